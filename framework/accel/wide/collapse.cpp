#include "accel/wide/collapse.h"
#include <algorithm>

namespace accel::wide {
namespace {

    constexpr float infinity = std::numeric_limits<float>::infinity();

    Block emptyBlock()
    {
        Block block;
        for (auto& axis : block.positions)
            for (auto& corner : axis)
                std::ranges::fill(corner, std::numeric_limits<float>::quiet_NaN());
        std::ranges::fill(block.primitives, ~uint32_t { 0 });
        return block;
    }

    Node emptyNode()
    {
        Node node;
        for (auto& axis : node.bounds) {
            std::ranges::fill(axis[0], infinity);
            std::ranges::fill(axis[1], -infinity);
        }
        std::ranges::fill(node.children, Child { 0 });
        return node;
    }

    struct Children {
        std::array<const BinaryNode*, width> nodes;
        std::size_t count = 0;
    };

    constexpr uint32_t fewReferences = 40; // are tested faster than boxes around them

    class Collapser {
    public:
        Collapser(const BinaryTree& tree, std::span<const Triangle> triangles)
            : m_tree(tree)
            , m_triangles(triangles)
        {
        }

        WideNodes collapse()
        {
            const BinaryNode& root = m_tree.nodes[0];
            if (root.numReferences <= fewReferences) {
                addBlocks(root);
            } else {
                m_wide.nodes.reserve(root.numReferences / 16); // more than it will take: what is not used costs nothing
                m_wide.blocks.reserve(root.numReferences / 3);
                m_wide.nodes.push_back(emptyNode());
                fill(0, root);
            }
            return std::move(m_wide);
        }

    private:
        static bool isBlock(const BinaryNode& node) { return node.share[0] == 0; }

        [[nodiscard]] const BinaryNode& child(const BinaryNode& node, std::size_t i) const
        {
            return m_tree.nodes[node.children[i]];
        }

        // Children lie side by side: nodes with nodes, blocks with blocks. The smallest comes first: who asks whether
        // there is anything at all begins with it, since it is soonest done.
        void fill(std::size_t index, const BinaryNode& binary)
        {
            Children children;
            addChildren(child(binary, 0), binary.share[0], children);
            addChildren(child(binary, 1), static_cast<std::size_t>(width - binary.share[0]), children);

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
            addChildren(child(node, 0), share, children);
            addChildren(child(node, 1), numBoxes - share, children);
        }

        static void setBox(Node& node, std::size_t i, const Box& box)
        {
            for (int axis = 0; axis < 3; ++axis) {
                node.bounds[axis][0][i] = box.lower[axis];
                node.bounds[axis][1][i] = box.upper[axis];
            }
        }

        // As many as it takes.
        void addBlocks(const BinaryNode& node)
        {
            m_primitives.clear();
            gatherPrimitives(node);
            std::ranges::sort(m_primitives); // parts of one triangle have met again
            m_primitives.erase(std::unique(m_primitives.begin(), m_primitives.end()), m_primitives.end());
            for (std::size_t first = 0; first < m_primitives.size(); first += width)
                m_wide.blocks.push_back(makeBlock(first));
        }

        [[nodiscard]] Block makeBlock(std::size_t first) const
        {
            Block block = emptyBlock();
            for (std::size_t i = 0; i < width && first + i < m_primitives.size(); ++i) {
                block.primitives[i] = m_primitives[first + i];
                for (int axis = 0; axis < 3; ++axis)
                    for (std::size_t corner = 0; corner < 3; ++corner)
                        block.positions[axis][corner][i] = m_triangles[block.primitives[i]][corner][axis];
            }
            return block;
        }

        void gatherPrimitives(const BinaryNode& node)
        {
            if (!node.isLeaf()) {
                gatherPrimitives(child(node, 0));
                gatherPrimitives(child(node, 1));
                return;
            }
            for (uint32_t i = 0; i < node.numReferences; ++i)
                m_primitives.push_back(m_tree.references[node.first + i].primitive());
        }

        const BinaryTree& m_tree;
        std::span<const Triangle> m_triangles;
        WideNodes m_wide;
        std::vector<uint32_t> m_primitives; // of one node
    };

}

WideNodes collapse(const BinaryTree& tree, std::span<const Triangle> triangles)
{
    return Collapser(tree, triangles).collapse();
}

}
