#pragma once
#include "worker/message.h"
#include <array>
#include <framework/ray.h>

namespace worker {

// The probe traversal.build: a tree of these, by the submission's BVH. Answers the seconds that it took.
using TraversalTriangles = std::vector<std::array<glm::vec3, 3>>;

// The probe traversal.trace: rays, for that tree's intersect.
using TraversalRays = std::vector<Ray>;

struct TraversalAnswer {
    double seconds = 0.0; // of tracing alone
    std::vector<float> distances; // one a ray; infinity where it meets nothing
};

inline Message& operator<<(Message& message, const TraversalAnswer& a)
{
    return message << a.seconds << a.distances;
}

inline Reader& operator>>(Reader& reader, TraversalAnswer& a)
{
    return reader >> a.seconds >> a.distances;
}

}
