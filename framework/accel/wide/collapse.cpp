#include "accel/wide/collapse.h"
#include "accel/wide/node_boxes.h"
#include <algorithm>

namespace accel::wide {
namespace {

    struct Children {
        std::array<const BinaryNode*, width> nodes;
        std::size_t count = 0;
    };

    class Collapser {
    public:
        Collapser(std::span<const BinaryNode> nodes, const Splitter& splitter)
            : m_nodes(nodes)
            , m_splitter(splitter)
        {
        }

        WideNodes collapse()
        {
            const BinaryNode& root = m_nodes[0];
            if (isBlock(root)) {
                addBlocks(root);
            } else {
                m_wide.nodes.reserve(root.numReferences / 16); // more than it will take: what is not used costs nothing
                m_wide.blocks.reserve(root.numReferences / 3);
                m_wide.nodes.emplace_back();
                fill(0, root);
            }
            return std::move(m_wide);
        }

    private:
        static bool isBlock(const BinaryNode& node) { return node.share[0] == 0; }

        // Children lie side by side: nodes with nodes, blocks with blocks. The smallest comes first: who asks whether
        // there is anything at all begins with it, since it is soonest done.
        void fill(std::size_t index, const BinaryNode& binary)
        {
            Children children;
            addChildren(m_nodes[binary.children[0]], binary.share[0], children);
            addChildren(m_nodes[binary.children[1]], static_cast<std::size_t>(width - binary.share[0]), children);

            std::sort(children.nodes.begin(), children.nodes.begin() + static_cast<std::ptrdiff_t>(children.count),
                [](const BinaryNode* a, const BinaryNode* b) { return a->box.halfArea() < b->box.halfArea(); });
            Node node = emptyNode();
            for (std::size_t i = 0; i < children.count; ++i) {
                setBox(node, i, children.nodes[i]->box);
                if (isBlock(*children.nodes[i])) {
                    node.children[i] = blockBit | blockStride * static_cast<Child>(m_wide.blocks.size());
                    addBlocks(*children.nodes[i]);
                } else {
                    node.children[i] = nodeStride * static_cast<Child>(m_wide.nodes.size());
                    m_wide.nodes.emplace_back();
                }
            }
            m_wide.nodes[index] = node;
            for (std::size_t i = 0; i < children.count; ++i)
                if (!isBlock(*children.nodes[i]))
                    fill(node.children[i] / nodeStride, *children.nodes[i]);
        }

        // The subtree as at most so many boxes.
        void addChildren(const BinaryNode& node, std::size_t numBoxes, Children& children) const
        {
            while (numBoxes > 1 && node.share[numBoxes - 1] == 0)
                --numBoxes;
            if (numBoxes == 1) {
                children.nodes[children.count++] = &node;
                return;
            }
            const std::size_t share = node.share[numBoxes - 1];
            addChildren(m_nodes[node.children[0]], share, children);
            addChildren(m_nodes[node.children[1]], numBoxes - share, children);
        }

        void addBlocks(const BinaryNode& node)
        {
            m_primitives.clear();
            gatherPrimitives(node);
            wide::addBlocks(m_primitives, m_splitter.triangles(), m_wide.blocks);
        }

        void gatherPrimitives(const BinaryNode& node)
        {
            if (!node.isLeaf()) {
                gatherPrimitives(m_nodes[node.children[0]]);
                gatherPrimitives(m_nodes[node.children[1]]);
                return;
            }
            for (const Reference& reference : m_splitter.references(node.first, node.numReferences))
                m_primitives.push_back(reference.primitive());
        }

        std::span<const BinaryNode> m_nodes;
        const Splitter& m_splitter;
        WideNodes m_wide;
        std::vector<uint32_t> m_primitives; // of one node
    };

}

WideNodes collapse(std::span<const BinaryNode> nodes, const Splitter& splitter)
{
    return Collapser(nodes, splitter).collapse();
}

}
