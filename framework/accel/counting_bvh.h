#pragma once
#include "accel/ray_counts.h"
#include "accel/wrapped_bvh.h"

namespace accel {

// A tree that counts the rays that anybody sends into it, whoever traverses it.
class CountingBVH : public WrappedBVH {
public:
    using WrappedBVH::WrappedBVH;

    bool intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const override
    {
        ++counter().ofCause();
        return wrapped().intersect(state, ray, hitInfo);
    }

    bool isOccluded(RenderState& state, const Ray& ray) const override
    {
        const uint64_t clear = numClear();
        const bool isOccluded = wrapped().isOccluded(state, ray);
        if (numClear() == clear)
            ++counter().rays.shadow;
        return isOccluded;
    }

    // Somebody has left out a ray to a light that the surface could not show.
    static void addUnlit() { ++counter().rays.unlit; }

    // Somebody need not trace a ray that would meet nothing.
    static void addClear() { ++counter().rays.clear; }
    // How many such rays this thread had.
    [[nodiscard]] static uint64_t numClear() { return counter().rays.clear; }

    // Of all threads, since the process began. Only while nobody traces.
    [[nodiscard]] static RayCounts rayCounts();
    // Since this thread began.
    [[nodiscard]] static uint64_t numRaysOfThisThread() { return counter().rays.total(); }

private:
    // One a thread, so that counting neither waits nor shares a cache line; threads that end leave their count behind.
    struct alignas(64) Counter {
        Counter();
        ~Counter();
        uint64_t& ofCause(); // the one that a ray traced now is counted by
        RayCounts rays;
    };

    static Counter& counter();
};

}
