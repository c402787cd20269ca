#pragma once
#include "accel/counting_bvh.h"
#include "accel/wrapped_bvh.h"
#include <vector>

namespace accel {

// What one thread asked of a tree.
struct RecordedRays {
    std::vector<Ray> rays; // each as it was before it met something
    std::vector<Ray> shadowRays; // of which nobody asks what they meet
    uint64_t numHits = 0; // of both

    [[nodiscard]] std::size_t numRays() const { return rays.size() + shadowRays.size(); }
};

// A tree that keeps all rays that are traced in it, in their order. For one thread.
class RecordingBVH : public WrappedBVH {
public:
    RecordingBVH(BVHInterface& bvh, RecordedRays& recorded)
        : WrappedBVH(bvh)
        , m_recorded(recorded)
    {
    }

    bool intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const override
    {
        m_recorded.rays.push_back(ray);
        const bool isHit = wrapped().intersect(state, ray, hitInfo);
        m_recorded.numHits += isHit;
        return isHit;
    }

    bool isOccluded(RenderState& state, const Ray& ray) const override
    {
        const uint64_t clear = CountingBVH::numClear();
        const bool isHit = wrapped().isOccluded(state, ray);
        if (CountingBVH::numClear() == clear)
            m_recorded.shadowRays.push_back(ray);
        m_recorded.numHits += isHit;
        return isHit;
    }

private:
    RecordedRays& m_recorded;
};

}
