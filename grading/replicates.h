#pragma once
#include "worker/message.h"
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace grading {

// Width of the tiles by which replicates are reported.
inline constexpr int finestTile = 4; // pixels

// Of a scene's features; names as in files::featureNames.
struct Setting {
    std::string name, value;
};

// A picture of a scene file, once for each seed.
struct ReplicatesRequest {
    std::string scene; // path, from the sources' root
    std::vector<Setting> settings; // other than the scene's
    glm::ivec2 size { 0 }; // pixels, multiples of finestTile
    std::vector<uint32_t> seeds;
};

// What came of it. Rows from the bottom; linear colours.
struct Replicates {
    glm::ivec2 size { 0 }; // pixels
    std::vector<glm::vec3> mean; // of the replicates, for each pixel
    std::vector<std::vector<glm::vec3>> tiles; // for each replicate: the mean of each tile of finestTile x finestTile
};

inline worker::Message& operator<<(worker::Message& message, const Setting& s)
{
    return message << s.name << s.value;
}

inline worker::Reader& operator>>(worker::Reader& reader, Setting& s)
{
    return reader >> s.name >> s.value;
}

inline worker::Message& operator<<(worker::Message& message, const ReplicatesRequest& r)
{
    return message << r.scene << r.settings << r.size << r.seeds;
}

inline worker::Reader& operator>>(worker::Reader& reader, ReplicatesRequest& r)
{
    return reader >> r.scene >> r.settings >> r.size >> r.seeds;
}

inline worker::Message& operator<<(worker::Message& message, const Replicates& r)
{
    return message << r.size << r.mean << r.tiles;
}

inline worker::Reader& operator>>(worker::Reader& reader, Replicates& r)
{
    return reader >> r.size >> r.mean >> r.tiles;
}

}
