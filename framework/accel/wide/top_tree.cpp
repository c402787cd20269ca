#include "accel/wide/top_tree.h"
#include "accel/wide/node_boxes.h"
#include <iterator>
#include <tbb/parallel_for_each.h>

namespace accel::wide {

constexpr uint32_t subtreeSize = 1 << 14; // references, at most

struct TopTree::Growing {
    Subtree subtree;
    std::vector<Growing> children = {}; // none: it is one of the subtrees

    [[nodiscard]] float area() const { return subtree.box.halfArea(); }

    void grow(const Splitter& splitter)
    {
        if (subtree.count <= subtreeSize)
            return;
        children.push_back({ subtree });
        while (children.size() < width)
            if (!splitLargest(splitter))
                break;
        std::ranges::sort(children, {}, &Growing::area); // the smallest is soonest done
        tbb::parallel_for_each(children, [&](Growing& child) { child.grow(splitter); });
    }

    // Not what will be a block. Whether there is another.
    bool splitLargest(const Splitter& splitter)
    {
        Growing* largest = nullptr;
        for (Growing& child : children)
            if (child.subtree.count > width && (!largest || child.area() > largest->area()))
                largest = &child;
        if (!largest)
            return false;
        const Sides sides = splitter.split(largest->subtree);
        largest->subtree = sides.lower;
        children.push_back({ sides.upper });
        return true;
    }
};

TopTree::TopTree(const Splitter& splitter, const Subtree& root)
{
    Growing growing { root };
    growing.grow(splitter);
    if (growing.children.empty()) {
        m_subtrees.push_back(root);
    } else {
        m_nodes.emplace_back();
        fill(0, growing);
    }
}

// What is too small for a node becomes a block, which has no place yet.
void TopTree::fill(uint32_t index, const Growing& growing)
{
    Node node = emptyNode();
    const auto firstChild = static_cast<uint32_t>(m_nodes.size());
    for (uint32_t i = 0; const Growing& child : growing.children) {
        setBox(node, i, child.subtree.box);
        if (child.children.empty()) {
            m_subtrees.push_back(child.subtree);
            m_places.push_back({ index, i });
        }
        if (child.subtree.count > width) {
            node.children[i] = nodeStride * static_cast<Child>(m_nodes.size());
            m_nodes.emplace_back();
        }
        ++i;
    }
    m_nodes[index] = node;
    for (uint32_t next = firstChild; const Growing& child : growing.children) {
        if (!child.children.empty())
            fill(next, child);
        next += child.subtree.count > width;
    }
}

void TopTree::addSubtree(const WideNodes& subtree, WideNodes& wide)
{
    const auto [parent, child] = m_places[m_numAdded++];
    const Child firstBlock = blockStride * static_cast<Child>(wide.blocks.size());
    const Child firstNode = nodeStride * static_cast<Child>(wide.nodes.size());
    wide.blocks.insert(wide.blocks.end(), subtree.blocks.begin(), subtree.blocks.end());
    Child& place = wide.nodes[parent].children[child];
    if (subtree.nodes.empty()) {
        place = blockBit | firstBlock;
        return;
    }
    const auto moved = [&](Node node) {
        for (Child& c : node.children)
            if (c != 0) // the root, which is nobody's child, but stands where there is none
                c += (c & blockBit) != 0 ? firstBlock : firstNode - nodeStride;
        return node;
    };
    wide.nodes[place / nodeStride] = moved(subtree.nodes[0]);
    std::transform(subtree.nodes.begin() + 1, subtree.nodes.end(), std::back_inserter(wide.nodes), moved);
}

}
