#pragma once
#include "debug/quantity.h"
#include "scene.h"
#include "worker/explanation.h"
#include <framework/trackball.h>

// What a window asks its worker. The worker keeps the scene that it opened last, so that a change of the camera, of a
// setting or of a light costs nothing but the pixels.
namespace worker {

// The probe view.open: reads a scene file and builds its tree. Answers nothing.
struct OpenRequest {
    std::string scene; // path
    bool enableBvhSahBinning = false; // the one setting that the tree depends on
};

// What is to be seen of the open scene.
struct View {
    Trackball camera;
    Features features;
    std::vector<Scene::SceneLight> lights;
    glm::ivec2 size { 0 }; // pixels
    debug::Quantity quantity = debug::Quantity::Color;
    bool isCounted = false; // with more work than the rays: that is slower
};

// A picture comes in passes: each has the pixels whose coordinates are multiples of its stride, but for those of the
// pass before, whose stride is twice as large.
inline constexpr int coarsestStride = 8;

[[nodiscard]] inline bool isInPass(int stride, int x, int y)
{
    return stride == coarsestStride || x % (2 * stride) != 0 || y % (2 * stride) != 0;
}

// The probe view.rows: as many rows of a pass as can be traced in some time, one at least.
struct RowsRequest {
    View view;
    int stride = coarsestStride;
    int firstRow = 0; // a multiple of the stride
    double seconds = 0.0;
};

struct Rows {
    int end = 0; // the first row that is not among them
    std::vector<glm::vec3> pixels; // of the pass, row by row: the quantity, raw
    Work work; // no more than its rays, unless the view is counted
    std::vector<ExplainedPart> needs; // of the picture; none unless the view is counted
    std::size_t memory = 0; // bytes that the worker holds; 0: unknown
};

// The probe view.follow answers a DebugRay.
struct FollowRequest {
    View view;
    glm::ivec2 pixel { 0 };
};

inline Message& operator<<(Message& message, const OpenRequest& r)
{
    return message << r.scene << r.enableBvhSahBinning;
}

inline Reader& operator>>(Reader& reader, OpenRequest& r)
{
    return reader >> r.scene >> r.enableBvhSahBinning;
}

inline Message& operator<<(Message& message, const View& v)
{
    return message << v.camera << v.features << v.lights << v.size << v.quantity << v.isCounted;
}

inline Reader& operator>>(Reader& reader, View& v)
{
    return reader >> v.camera >> v.features >> v.lights >> v.size >> v.quantity >> v.isCounted;
}

inline Message& operator<<(Message& message, const RowsRequest& r)
{
    return message << r.view << r.stride << r.firstRow << r.seconds;
}

inline Reader& operator>>(Reader& reader, RowsRequest& r)
{
    return reader >> r.view >> r.stride >> r.firstRow >> r.seconds;
}

inline Message& operator<<(Message& message, const Rows& r)
{
    return message << r.end << r.pixels << r.work << r.needs << r.memory;
}

inline Reader& operator>>(Reader& reader, Rows& r)
{
    return reader >> r.end >> r.pixels >> r.work >> r.needs >> r.memory;
}

inline Message& operator<<(Message& message, const FollowRequest& r)
{
    return message << r.view << r.pixel;
}

inline Reader& operator>>(Reader& reader, FollowRequest& r)
{
    return reader >> r.view >> r.pixel;
}

}
