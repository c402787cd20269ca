#pragma once
#include "accel/ray_counts.h"
#include "bvh_interface.h"
#include <utility>

namespace accel {

// A tree that counts the rays that anybody sends into it, whoever traverses it.
class CountingBVH : public BVHInterface {
public:
    explicit CountingBVH(BVHInterface& bvh)
        : m_bvh(bvh)
    {
    }

    bool intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const override
    {
        ++counter().ofCause();
        return m_bvh.intersect(state, ray, hitInfo);
    }

    [[nodiscard]] std::span<const Node> nodes() const override { return std::as_const(m_bvh).nodes(); }
    [[nodiscard]] std::span<Node> nodes() override { return m_bvh.nodes(); }
    [[nodiscard]] std::span<const Primitive> primitives() const override { return std::as_const(m_bvh).primitives(); }
    [[nodiscard]] std::span<Primitive> primitives() override { return m_bvh.primitives(); }
    [[nodiscard]] uint32_t numLevels() const override { return m_bvh.numLevels(); }
    [[nodiscard]] uint32_t numLeaves() const override { return m_bvh.numLeaves(); }
    [[nodiscard]] const WideTree* wideTree() const override { return m_bvh.wideTree(); }

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

    BVHInterface& m_bvh;
};

}
