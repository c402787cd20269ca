#include "accel/wide/build.h"
#include "accel/wide/in_parts.h"
#include "accel/wide/top_tree.h"
#include <algorithm>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

namespace accel::wide {
namespace {

    constexpr float roomForCuts = 0.25f; // references more than triangles, at most
    constexpr uint32_t fewTriangles = 40; // are tested faster than boxes around them

    Box boundsOf(const Triangle& triangle)
    {
        Box box { toFloat4(triangle[0]), toFloat4(triangle[0]) };
        box.add(toFloat4(triangle[1]));
        box.add(toFloat4(triangle[2]));
        return box;
    }

    // All that can be met.
    struct Contents {
        Box box = Box::empty();
        uint32_t count = 0;

        void add(const Contents& other)
        {
            box.add(other.box);
            count += other.count;
        }
    };

    Contents makeReferences(const Triangles& triangles, Reference* references)
    {
        Contents contents;
        addInParts(contents, triangles.size(), [&](Contents& sum, uint32_t begin, uint32_t end) {
            for (uint32_t i = begin; i < end; ++i) {
                references[i].box = boundsOf(triangles[i]);
                if (references[i].box.isFinite())
                    sum.add({ references[i].box, 1 });
                references[i].setPrimitive(i);
            }
        });
        if (contents.count < triangles.size())
            (void)std::remove_if(references, references + triangles.size(),
                [](const Reference& reference) { return !reference.box.isFinite(); });
        return contents;
    }

    WideNodes withoutNodes(std::span<const Reference> references, const Triangles& triangles)
    {
        std::vector<uint32_t> primitives;
        for (const Reference& reference : references)
            primitives.push_back(reference.primitive());
        WideNodes wide;
        addBlocks(primitives, triangles, wide.blocks);
        return wide;
    }

    // Room for the binary nodes of one subtree after another: memory that is new takes long.
    class BinaryRoom {
    public:
        std::span<BinaryNode> of(const Subtree& subtree)
        {
            const std::size_t size = 2 * std::size_t { subtree.capacity };
            if (m_size < size) {
                m_nodes = makeLargeArray<BinaryNode>(size);
                m_size = size;
            }
            return { m_nodes.get(), size };
        }

    private:
        LargeArray<BinaryNode> m_nodes;
        std::size_t m_size = 0;
    };

    WideNodes buildSubtree(const Splitter& splitter, const Subtree& subtree, BinaryRoom& room)
    {
        const std::span<BinaryNode> nodes = room.of(subtree);
        buildBinaryTree(splitter, subtree, nodes);
        return collapse(nodes, splitter);
    }

    // Some subtrees are built while others are added, in their order.
    WideNodes buildSubtrees(const Splitter& splitter, TopTree& top, uint32_t numReferences)
    {
        WideNodes wide = top.withoutSubtrees();
        wide.nodes.reserve(numReferences / 16); // more than it will take: what is not used costs nothing
        wide.blocks.reserve(numReferences / 3);
        const auto maxInWork = static_cast<uint32_t>(2 * tbb::this_task_arena::max_concurrency());
        std::vector<BinaryRoom> rooms(maxInWork);
        uint32_t numBegun = 0;
        const auto begin = [&](tbb::flow_control& control) {
            if (numBegun == top.subtrees().size())
                control.stop();
            return numBegun++;
        };
        const auto build = [&](uint32_t i) { return buildSubtree(splitter, top.subtrees()[i], rooms[i % maxInWork]); };
        const auto add = [&](const WideNodes& subtree) { top.addSubtree(subtree, wide); };
        tbb::parallel_pipeline(maxInWork,
            tbb::make_filter<void, uint32_t>(tbb::filter_mode::serial_in_order, begin)
                & tbb::make_filter<uint32_t, WideNodes>(tbb::filter_mode::parallel, build)
                & tbb::make_filter<WideNodes, void>(tbb::filter_mode::serial_in_order, add));
        return wide;
    }

}

Built build(const Triangles& triangles)
{
    const auto capacity = triangles.size() + static_cast<uint32_t>(roomForCuts * static_cast<float>(triangles.size()));
    const auto references = makeLargeArray<Reference>(capacity);
    const auto [box, count] = makeReferences(triangles, references.get());
    if (count <= fewTriangles)
        return { withoutNodes({ references.get(), count }, triangles), box };
    const Splitter splitter(triangles, references.get(), box.halfArea());
    TopTree top(splitter, { 0, count, capacity, box, 1 });
    BinaryRoom room;
    const bool isOne = top.subtrees().size() == 1;
    return { isOne ? buildSubtree(splitter, top.subtrees()[0], room) : buildSubtrees(splitter, top, count), box };
}

}
