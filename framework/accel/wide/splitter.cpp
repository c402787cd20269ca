#include "accel/wide/splitter.h"
#include "accel/wide/clip.h"
#include "accel/wide/in_parts.h"
#include "accel/wide/node.h"
#include "accel/wide/object_split.h"
#include "accel/wide/spatial_split.h"
#include <algorithm>
#include <tbb/parallel_invoke.h>
#include <vector>

namespace accel::wide {
namespace {

    constexpr uint32_t medianDepth = maxDepth / 2; // from here halves: 2^32 triangles fit into the levels that are left
    // How much of the root's and of the node's surface must lie in both halves before it pays to look for a cut, and of
    // how many references.
    constexpr float overlapOfRoot = 1e-5f, overlapOfNode = 0.2f;
    constexpr uint32_t fewestToCut = 64;

    Box centroidsOf(std::span<const Reference> references)
    {
        Box box = Box::empty();
        addInParts(box, static_cast<uint32_t>(references.size()), [&](Box& sum, uint32_t begin, uint32_t end) {
            for (uint32_t i = begin; i < end; ++i)
                sum.add(references[i].doubledCentroid());
        });
        return box;
    }

    void addAll(ObjectBins& bins, std::span<const Reference> references)
    {
        addInParts(bins, static_cast<uint32_t>(references.size()),
            [&](ObjectBins& sum, uint32_t begin, uint32_t end) { sum.add(references.subspan(begin, end - begin)); });
    }

    Box boundsOf(std::span<const Reference> references)
    {
        Box box = Box::empty();
        for (const Reference& r : references)
            box.add(r.box);
        return box;
    }

    // Those that are below to the front, without jumps, which nobody could foresee. Returns how many.
    template <typename IsBelow> uint32_t partitionPart(std::span<Reference> references, const IsBelow& isBelow)
    {
        uint32_t numBelow = 0;
        for (Reference& reference : references) {
            const Reference moved = reference;
            reference = references[numBelow];
            references[numBelow] = moved;
            numBelow += isBelow(moved);
        }
        return numBelow;
    }

    template <typename IsBelow> uint32_t partition(std::span<Reference> references, const IsBelow& isBelow)
    {
        if (references.size() <= partSize)
            return partitionPart(references, isBelow);
        const auto half = static_cast<uint32_t>(references.size() / 2);
        const auto first = references.first(half), second = references.subspan(half);
        uint32_t firstBelow = 0, secondBelow = 0;
        tbb::parallel_invoke(
            [&] { firstBelow = partition(first, isBelow); }, [&] { secondBelow = partition(second, isBelow); });
        const uint32_t numMoved = std::min(half - firstBelow, secondBelow); // what lies in between changes places
        std::swap_ranges(first.begin() + firstBelow, first.begin() + firstBelow + numMoved,
            second.begin() + (secondBelow - numMoved));
        return firstBelow + secondBelow;
    }

    void append(std::vector<Reference>& references, const Box& box, uint32_t primitive)
    {
        if (box.isEmpty())
            return;
        references.push_back({ box });
        references.back().setPrimitive(primitive);
    }

}

Sides Splitter::split(const Subtree& subtree) const
{
    if (subtree.depth >= medianDepth)
        return splitInHalves(subtree);
    const auto references = in(subtree);
    ObjectBins bins(centroidsOf(references), references.size());
    addAll(bins, references);
    const ObjectSplit objects = bins.best();
    if (const SpatialSplit space = findSpatial(subtree, objects); space.cost < objects.cost)
        if (const auto sides = splitSpace(subtree, space))
            return *sides;
    if (objects.axis < 0) // coinciding centroids
        return splitInHalves(subtree);
    const uint32_t numLower = partition(references, [&](const Reference& r) { return bins.isBelow(r, objects); });
    return arrange(subtree, numLower, objects.lower, objects.upper);
}

SpatialSplit Splitter::findSpatial(const Subtree& subtree, const ObjectSplit& objects) const
{
    const uint32_t room = subtree.capacity - subtree.count;
    if (room == 0 || objects.axis < 0 || subtree.count < fewestToCut)
        return {};
    const Box overlap = intersect(objects.lower, objects.upper);
    const float least = std::max(overlapOfRoot * m_rootArea, overlapOfNode * subtree.box.halfArea());
    if (overlap.isEmpty() || overlap.halfArea() < least)
        return {};
    return findSpatialSplit(in(subtree), subtree.box, m_triangles, room);
}

// Nothing if all ends up on one side.
std::optional<Sides> Splitter::splitSpace(const Subtree& subtree, const SpatialSplit& split) const
{
    std::vector<Reference> lower, upper;
    lower.reserve(subtree.count);
    upper.reserve(subtree.count);
    for (const Reference& r : in(subtree)) {
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
    if (lower.empty() || upper.empty() || lower.size() + upper.size() > subtree.capacity)
        return std::nullopt;
    std::ranges::copy(upper, std::ranges::copy(lower, m_references + subtree.first).out);
    Subtree cut = subtree;
    cut.count = static_cast<uint32_t>(lower.size() + upper.size());
    return arrange(cut, static_cast<uint32_t>(lower.size()), boundsOf(lower), boundsOf(upper));
}

Sides Splitter::splitInHalves(const Subtree& subtree) const
{
    const auto references = in(subtree);
    const uint32_t half = subtree.count / 2;
    return arrange(subtree, half, boundsOf(references.first(half)), boundsOf(references.subspan(half)));
}

// The first of the subtree's references go to the lower side. Each side gets its share of the room.
Sides Splitter::arrange(const Subtree& subtree, uint32_t numLower, const Box& lower, const Box& upper) const
{
    const uint32_t numUpper = subtree.count - numLower;
    const auto room = static_cast<uint32_t>(uint64_t(subtree.capacity - subtree.count) * numLower / subtree.count);
    const uint32_t numMoved = std::min(room, numUpper);
    Reference* const upperReferences = m_references + subtree.first + numLower;
    std::copy_n(upperReferences, numMoved, upperReferences + room + numUpper - numMoved);
    const uint32_t lowerCapacity = numLower + room;
    return { { subtree.first, numLower, lowerCapacity, lower, subtree.depth + 1 },
        { subtree.first + lowerCapacity, numUpper, subtree.capacity - lowerCapacity, upper, subtree.depth + 1 } };
}

}
