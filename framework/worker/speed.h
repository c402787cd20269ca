#pragma once
#include "worker/render_request.h"

namespace worker {

// What the probe render.speed is asked for.
struct SpeedRequest {
    RenderRequest render; // its scene, settings and size
    uint32_t numRepetitions = 1;
};

// What it took somebody to answer rays, as often as it was asked.
struct Timing {
    uint32_t numThreads = 1;
    uint64_t numRays = 0; // each time
    uint64_t numHits = 0; // of them, those that met something
    std::vector<double> seconds; // one a repetition
};

// Frames are by renderImage; a frame's rays are all that it sends into the tree. In a repetition everybody has a turn.
struct Speed {
    uint64_t numTriangles = 0;
    Timing frame; // the library traverses the tree
    Timing hits; // that frame's rays by intersectRayWithBVH
    Timing traversal; // that frame's rays by the library's tree alone, which finds distances and no more
    std::vector<Timing> threadedFrames; // that frame with two threads, and with one a core where there are more
    Timing theirFrame; // BVH::intersect of the submission traverses the tree
    Timing theirHits; // the rays of `frame` by BVH::intersect
};

inline Message& operator<<(Message& message, const SpeedRequest& r)
{
    return message << r.render << r.numRepetitions;
}

inline Reader& operator>>(Reader& reader, SpeedRequest& r)
{
    return reader >> r.render >> r.numRepetitions;
}

inline Message& operator<<(Message& message, const Timing& t)
{
    return message << t.numThreads << t.numRays << t.numHits << t.seconds;
}

inline Reader& operator>>(Reader& reader, Timing& t)
{
    return reader >> t.numThreads >> t.numRays >> t.numHits >> t.seconds;
}

inline Message& operator<<(Message& message, const Speed& s)
{
    return message << s.numTriangles << s.frame << s.hits << s.traversal << s.threadedFrames << s.theirFrame
                   << s.theirHits;
}

inline Reader& operator>>(Reader& reader, Speed& s)
{
    return reader >> s.numTriangles >> s.frame >> s.hits >> s.traversal >> s.threadedFrames >> s.theirFrame
        >> s.theirHits;
}

}
