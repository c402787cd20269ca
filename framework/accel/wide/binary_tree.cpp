#include "accel/wide/binary_tree.h"
#include "accel/wide/collapse_cost.h"
#include <tbb/parallel_invoke.h>

namespace accel::wide {
namespace {

    constexpr uint32_t leafSize = 2; // a block has room for more: to part two gains nothing
    constexpr uint32_t parallelSize = 2048; // references that are worth a task of their own

    class Builder {
    public:
        Builder(const Splitter& splitter, std::span<BinaryNode> nodes)
            : m_splitter(splitter)
            , m_nodes(nodes)
        {
        }

        CollapseCosts build(const Subtree& subtree, uint32_t index) const
        {
            BinaryNode& node = m_nodes[index];
            node.box = subtree.box;
            node.first = subtree.first;
            node.numReferences = subtree.count;
            node.children[0] = node.children[1] = 0;
            return subtree.count > leafSize ? buildChildren(node, index, m_splitter.split(subtree))
                                            : collapseLeaf(node);
        }

    private:
        // The places of a subtree's nodes follow from its references, so that threads need not ask each other.
        CollapseCosts buildChildren(BinaryNode& node, uint32_t index, const Sides& sides) const
        {
            node.children[0] = index + 1;
            node.children[1] = index + 2 * sides.lower.capacity; // n leaves have n - 1 nodes above them
            CollapseCosts lower, upper;
            const auto buildLower = [&] { lower = build(sides.lower, node.children[0]); };
            const auto buildUpper = [&] { upper = build(sides.upper, node.children[1]); };
            if (node.numReferences >= parallelSize)
                tbb::parallel_invoke(buildLower, buildUpper);
            else
                buildLower(), buildUpper();
            node.numReferences // cuts below add to them
                = m_nodes[node.children[0]].numReferences + m_nodes[node.children[1]].numReferences;
            return collapseInner(node, lower, upper);
        }

        const Splitter& m_splitter;
        std::span<BinaryNode> m_nodes;
    };

}

void buildBinaryTree(const Splitter& splitter, const Subtree& subtree, std::span<BinaryNode> nodes)
{
    (void)Builder(splitter, nodes).build(subtree, 0);
}

}
