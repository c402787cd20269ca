#include "accel/expected_rays.h"

namespace accel {

static void prefetch(const BVHInterface::Primitive& primitive)
{
    const char* const bytes = reinterpret_cast<const char*>(&primitive);
    for (std::size_t i = 0; i < sizeof primitive; i += 64)
        __builtin_prefetch(bytes + i);
}

void ExpectedRays::trace(const WideTree& tree, const BVHInterface& bvh)
{
    m_tree = &tree;
    BVHInterface::Primitive room; // to put one together is to fetch it, too
    tree.closest(m_rays.subspan(m_next), std::span(m_hits).subspan(m_next));
    for (std::size_t i = m_next; i < m_rays.size(); ++i)
        if (m_hits[i])
            prefetch(bvh.primitive(m_hits[i]->primitive, room));
}

}
