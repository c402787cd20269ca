#pragma once
#include "debug/quantity.h"
#include "worker/message.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace worker {

// What the probe render.image is asked for: a scene file, and what differs from what it says.
struct RenderRequest {
    std::string scene; // path
    std::vector<std::string> settings; // "name=value", names as in files::featureNames
    glm::ivec2 size { 0 }; // pixels; 0: the scene file's
    glm::vec2 orbit { 0.0f }; // degrees about x and y that the camera is turned by around what it looks at
    uint32_t numThreads = 0; // 0: all cores
    bool wantsProgress = false;
    debug::Quantity quantity = debug::Quantity::Color;
};

struct Rendering {
    glm::ivec2 size { 0 };
    std::vector<glm::vec3> pixels; // row 0 at the bottom: the quantity, raw
    double seconds = 0.0; // of rendering alone
    uint64_t numRays = 0; // of all kinds
};

inline Message& operator<<(Message& message, const RenderRequest& r)
{
    return message << r.scene << r.settings << r.size << r.orbit << r.numThreads << r.wantsProgress << r.quantity;
}

inline Reader& operator>>(Reader& reader, RenderRequest& r)
{
    return reader >> r.scene >> r.settings >> r.size >> r.orbit >> r.numThreads >> r.wantsProgress >> r.quantity;
}

inline Message& operator<<(Message& message, const Rendering& r)
{
    return message << r.size << r.pixels << r.seconds << r.numRays;
}

inline Reader& operator>>(Reader& reader, Rendering& r)
{
    return reader >> r.size >> r.pixels >> r.seconds >> r.numRays;
}

}
