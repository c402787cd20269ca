#include "accel/wide/tree.h"
#include "accel/wide/collapse.h"

namespace accel {

WideTree::WideTree(std::span<const Triangle> triangles, const wide::Kernel& kernel)
    : m_kernel(kernel)
{
    if (const wide::BinaryTree binary = wide::buildBinaryTree(triangles); binary.nodes) {
        wide::WideNodes wide = wide::collapse(binary, triangles);
        m_nodes = std::move(wide.nodes);
        m_blocks = std::move(wide.blocks);
        for (int i = 0; i < 3; ++i) {
            const wide::Box& box = binary.nodes[0].box;
            m_view.middle[i] = 0.5f * box.lower[i] + 0.5f * box.upper[i];
            m_view.halfSize[i] = (0.5f * box.upper[i] - 0.5f * box.lower[i]) * (1.0f + 1e-6f); // no less after rounding
        }
    }
    m_view.nodes = m_nodes.data();
    m_view.blocks = m_blocks.data();
    m_view.numNodes = static_cast<uint32_t>(m_nodes.size());
    m_view.numBlocks = static_cast<uint32_t>(m_blocks.size());
}

std::optional<WideTree::Hit> WideTree::closest(const Ray& ray, wide::Counters& counters) const
{
    Hit hit;
    return m_kernel.closestCounted(m_view, ray, hit, counters) ? std::optional(hit) : std::nullopt;
}

bool WideTree::occluded(const Ray& ray, wide::Counters& counters) const
{
    return m_kernel.occludedCounted(m_view, ray, counters);
}

std::size_t WideTree::numBytes() const
{
    return m_nodes.size() * sizeof(wide::Node) + m_blocks.size() * sizeof(wide::Block);
}

}
