#pragma once
#include "accel/wide/collapse.h"

namespace accel::wide {

// Of a large tree the wide nodes above subtrees that are built and made wide one after the other: what that takes,
// apart from what comes of it, is needed for a few of them only, and stays in the processor's caches.
class TopTree {
public:
    TopTree(const Splitter& splitter, const Subtree& root);

    // In the order in which they are to be added; the tree itself if it is small.
    [[nodiscard]] std::span<const Subtree> subtrees() const { return m_subtrees; }

    [[nodiscard]] WideNodes withoutSubtrees() const { return { m_nodes, {} }; }
    // Puts the next subtree into its place.
    void addSubtree(const WideNodes& subtree, WideNodes& wide);

private:
    struct Growing;
    struct Place {
        uint32_t node, child; // whose child it is
    };

    void fill(uint32_t index, const Growing& growing);

    std::vector<Node, LargePages<Node>> m_nodes;
    std::vector<Subtree> m_subtrees;
    std::vector<Place> m_places; // of the subtrees
    uint32_t m_numAdded = 0;
};

}
