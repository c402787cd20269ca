#include "accel/wide/binary_tree.h"
#include "accel/wide/clip.h"
#include "accel/wide/collapse_cost.h"
#include "accel/wide/object_split.h"
#include "accel/wide/spatial_split.h"
#include <algorithm>
#include <optional>
#include <tbb/parallel_invoke.h>
#include <vector>

namespace accel::wide {
namespace {

    constexpr uint32_t medianDepth = maxDepth / 2; // from here halves: 2^32 triangles fit into the levels that are left
    constexpr uint32_t leafSize = 2; // a block has room for more: to part two gains nothing
    constexpr uint32_t parallelSize = 2048; // references that are worth a task of their own
    constexpr float roomForCuts = 0.25f; // references more than triangles, at most
    // How much of the root's and of the node's surface must lie in both halves before it pays to look for a cut.
    constexpr float overlapOfRoot = 1e-5f, overlapOfNode = 0.2f;

    // A place in the array of references: some in use, then room for parts of those that are cut.
    struct Range {
        uint32_t first, count, capacity;
    };

    // The places of a subtree's nodes follow from its references, so that threads need not ask each other.
    struct Subtree {
        uint32_t node;
        Range range;
        Box box;
        uint32_t depth;
    };

    struct Sides {
        Subtree lower, upper;
    };

    class Builder {
    public:
        Builder(std::span<const Triangle> triangles, BinaryTree& tree, float rootArea)
            : m_triangles(triangles)
            , m_tree(tree)
            , m_rootArea(rootArea)
        {
        }

        CollapseCosts build(const Subtree& subtree) const
        {
            BinaryNode& node = m_tree.nodes[subtree.node];
            node.box = subtree.box;
            node.first = subtree.range.first;
            node.numReferences = subtree.range.count;
            node.children[0] = node.children[1] = 0;
            return subtree.range.count > leafSize ? buildChildren(node, split(subtree)) : collapseLeaf(node);
        }

    private:
        CollapseCosts buildChildren(BinaryNode& node, const Sides& sides) const
        {
            node.children[0] = sides.lower.node;
            node.children[1] = sides.upper.node;
            CollapseCosts lower, upper;
            const auto buildLower = [&] { lower = build(sides.lower); };
            const auto buildUpper = [&] { upper = build(sides.upper); };
            if (node.numReferences >= parallelSize)
                tbb::parallel_invoke(buildLower, buildUpper);
            else
                buildLower(), buildUpper();
            node.numReferences = m_tree.nodes[node.children[0]].numReferences // cuts below add to them
                + m_tree.nodes[node.children[1]].numReferences;
            return collapseInner(node, lower, upper);
        }

        [[nodiscard]] Sides split(const Subtree& subtree) const
        {
            const auto references = in(subtree.range);
            Box centroids = Box::empty();
            for (const Reference& r : references)
                centroids.add(r.doubledCentroid());
            if (subtree.depth >= medianDepth)
                return splitInHalves(subtree);
            const ObjectBins bins(references, centroids);
            const ObjectSplit objects = bins.best();
            if (const SpatialSplit space = findSpatial(subtree, objects); space.cost < objects.cost)
                if (const auto sides = splitSpace(subtree, space))
                    return *sides;
            if (objects.axis < 0) // coinciding centroids
                return splitInHalves(subtree);
            const auto middle = std::partition(
                references.begin(), references.end(), [&](const Reference& r) { return bins.isBelow(r, objects); });
            return arrange(subtree, static_cast<uint32_t>(middle - references.begin()), objects.lower, objects.upper);
        }

        [[nodiscard]] SpatialSplit findSpatial(const Subtree& subtree, const ObjectSplit& objects) const
        {
            const uint32_t room = subtree.range.capacity - subtree.range.count;
            if (room == 0 || objects.axis < 0 || subtree.range.count <= width) // these fit into one block
                return {};
            const Box overlap = intersect(objects.lower, objects.upper);
            const float least = std::max(overlapOfRoot * m_rootArea, overlapOfNode * subtree.box.halfArea());
            if (overlap.isEmpty() || overlap.halfArea() < least)
                return {};
            return findSpatialSplit(in(subtree.range), subtree.box, m_triangles, room);
        }

        // Nothing if all ends up on one side.
        [[nodiscard]] std::optional<Sides> splitSpace(const Subtree& subtree, const SpatialSplit& split) const
        {
            std::vector<Reference> lower, upper;
            for (const Reference& r : in(subtree.range)) {
                Halves halves { Box::empty(), Box::empty() };
                if (r.box.upper[split.axis] <= split.position)
                    halves.lower = r.box;
                else if (r.box.lower[split.axis] >= split.position)
                    halves.upper = r.box;
                else
                    halves = clip(r.box, m_triangles[r.primitive()], split.axis, split.position);
                append(lower, halves.lower, r.primitive());
                append(upper, halves.upper, r.primitive());
            }
            if (lower.empty() || upper.empty() || lower.size() + upper.size() > subtree.range.capacity)
                return std::nullopt;
            const auto to = m_tree.references.get() + subtree.range.first;
            std::ranges::copy(upper, std::ranges::copy(lower, to).out);
            Subtree cut = subtree;
            cut.range.count = static_cast<uint32_t>(lower.size() + upper.size());
            return arrange(cut, static_cast<uint32_t>(lower.size()), boundsOf(lower), boundsOf(upper));
        }

        static void append(std::vector<Reference>& references, const Box& box, uint32_t primitive)
        {
            if (box.isEmpty())
                return;
            references.push_back({ box });
            references.back().setPrimitive(primitive);
        }

        [[nodiscard]] Sides splitInHalves(const Subtree& subtree) const
        {
            const auto references = in(subtree.range);
            const uint32_t half = subtree.range.count / 2;
            return arrange(subtree, half, boundsOf(references.first(half)), boundsOf(references.subspan(half)));
        }

        // The first of the subtree's references go to the lower side. Each side gets its share of the room.
        [[nodiscard]] Sides arrange(const Subtree& subtree, uint32_t numLower, const Box& lower, const Box& upper) const
        {
            const auto [first, count, capacity] = subtree.range;
            const uint32_t numUpper = count - numLower;
            const auto room = static_cast<uint32_t>(uint64_t(capacity - count) * numLower / count);
            const uint32_t numMoved = std::min(room, numUpper);
            Reference* const upperReferences = m_tree.references.get() + first + numLower;
            std::copy_n(upperReferences, numMoved, upperReferences + room + numUpper - numMoved);
            const Range lowerRange { first, numLower, numLower + room };
            const Range upperRange { first + lowerRange.capacity, numUpper, capacity - lowerRange.capacity };
            const uint32_t lowerNode = subtree.node + 1;
            const uint32_t upperNode = lowerNode + 2 * lowerRange.capacity - 1; // n leaves have n - 1 nodes above them
            return { { lowerNode, lowerRange, lower, subtree.depth + 1 },
                { upperNode, upperRange, upper, subtree.depth + 1 } };
        }

        static Box boundsOf(std::span<const Reference> references)
        {
            Box box = Box::empty();
            for (const Reference& r : references)
                box.add(r.box);
            return box;
        }

        [[nodiscard]] std::span<Reference> in(const Range& range) const
        {
            return { m_tree.references.get() + range.first, range.count };
        }

        std::span<const Triangle> m_triangles;
        BinaryTree& m_tree;
        float m_rootArea;
    };

    Box boundsOf(const Triangle& triangle)
    {
        Box box { toFloat4(triangle[0]), toFloat4(triangle[0]) };
        box.add(toFloat4(triangle[1]));
        box.add(toFloat4(triangle[2]));
        return box;
    }

}

BinaryTree buildBinaryTree(std::span<const Triangle> triangles)
{
    const auto numTriangles = static_cast<uint32_t>(triangles.size());
    const uint32_t capacity = numTriangles + static_cast<uint32_t>(roomForCuts * static_cast<float>(numTriangles));
    BinaryTree tree { makeLargeArray<BinaryNode>(2 * capacity), makeLargeArray<Reference>(capacity) };
    Box box = Box::empty();
    uint32_t count = 0;
    for (uint32_t i = 0; i < numTriangles; ++i) {
        const Box bounds = boundsOf(triangles[i]);
        if (!bounds.isFinite())
            continue;
        box.add(bounds);
        tree.references[count].box = bounds;
        tree.references[count++].setPrimitive(i);
    }
    if (count == 0)
        return {};
    Builder(triangles, tree, box.halfArea()).build({ 0, { 0, count, capacity }, box, 1 });
    return tree;
}

}
