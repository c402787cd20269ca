#include "accel/expected_rays.h"

namespace accel {

static void prefetch(const BVHInterface::Primitive& primitive)
{
    const char* const bytes = reinterpret_cast<const char*>(&primitive);
    for (std::size_t i = 0; i < sizeof primitive; i += 64)
        __builtin_prefetch(bytes + i);
}

void ExpectedRays::trace(const WideTree& tree, std::span<const BVHInterface::Primitive> primitives)
{
    m_tree = &tree;
    for (std::size_t i = m_next; i < m_rays.size(); ++i) {
        m_hits[i] = tree.closest(m_rays[i]);
        if (m_hits[i])
            prefetch(primitives[m_hits[i]->primitive]);
    }
}

}
