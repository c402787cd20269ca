#pragma once
#include "accel/wide/tree.h"
#include "bvh_interface.h"
#include <array>
#include <cstring>

namespace accel {

// Rays whose closest hits will be asked for one after the other, in this order, between which other things are done.
// When the first is, all are traced: so the processor works on several at once, and what is known of the triangles that
// they hit is on its way from memory before somebody wants it. If nobody asks, nothing is traced.
class ExpectedRays {
public:
    static constexpr std::size_t most = wide::mostRays;

    // Instead of those of before; they must stay where they are. Those beyond the first `most` are not expected.
    void expect(std::span<const Ray> rays)
    {
        m_rays = rays.first(std::min(rays.size(), most));
        m_next = 0;
        m_tree = nullptr;
    }

    [[nodiscard]] bool isNext(const Ray& ray) const
    {
        return m_next < m_rays.size() && std::memcmp(&m_rays[m_next], &ray, sizeof ray) == 0;
    }

    // The closest hit of the next ray. bvh: whose tree this is.
    const std::optional<WideTree::Hit>& takeNext(const WideTree& tree, const BVHInterface& bvh)
    {
        if (m_tree != &tree)
            trace(tree, bvh);
        return m_hits[m_next++];
    }

private:
    void trace(const WideTree& tree, const BVHInterface& bvh);

    std::span<const Ray> m_rays;
    std::size_t m_next = 0;
    const WideTree* m_tree = nullptr; // in which the hits were found
    std::array<std::optional<WideTree::Hit>, most> m_hits;
};

}
