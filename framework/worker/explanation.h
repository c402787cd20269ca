#pragma once
#include "accel/ray_counts.h"
#include "worker/message.h"

namespace worker {

struct ExplainedPart {
    std::string name;
    std::string whyNot; // it is left out; empty if it is not
};

// What the probe render.explain answers a RenderRequest: what the picture needs, and what was done for it.
struct Explanation {
    bool skips = true; // what it does not need is left out
    std::vector<ExplainedPart> parts;
    accel::RayCounts rays;
    uint64_t numNodes = 0, numTriangles = 0; // of the tree that everybody sees, by the library's traversal
    uint64_t numLookups = 0; // of textures
    uint32_t numTextures = 0, numDecoded = 0;
};

inline Message& operator<<(Message& message, const ExplainedPart& p)
{
    return message << p.name << p.whyNot;
}

inline Reader& operator>>(Reader& reader, ExplainedPart& p)
{
    return reader >> p.name >> p.whyNot;
}

inline Message& operator<<(Message& message, const Explanation& e)
{
    return message << e.skips << e.parts << e.rays << e.numNodes << e.numTriangles << e.numLookups << e.numTextures
                   << e.numDecoded;
}

inline Reader& operator>>(Reader& reader, Explanation& e)
{
    return reader >> e.skips >> e.parts >> e.rays >> e.numNodes >> e.numTriangles >> e.numLookups >> e.numTextures
        >> e.numDecoded;
}

}
