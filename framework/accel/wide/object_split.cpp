#include "accel/wide/object_split.h"

namespace accel::wide {

ObjectBins::ObjectBins(std::span<const Reference> references, const Box& centroids)
    : m_origin(centroids.lower)
{
    const Float4 extent = centroids.upper - centroids.lower;
    for (int axis = 0; axis < 4; ++axis) // a little less than all bins: the last centroid belongs to the last bin
        m_scale[axis] = axis < 3 && extent[axis] > 1e-30f ? 0.9999f * numBins / extent[axis] : 0.0f;
    for (auto& boxes : m_boxes)
        std::fill(std::begin(boxes), std::end(boxes), Box::empty());
    for (const Reference& reference : references) {
        const Int4 bin = binOf(reference.doubledCentroid());
        for (int axis = 0; axis < 3; ++axis) {
            m_boxes[axis][bin[axis]].add(reference.box);
            ++m_counts[axis][bin[axis]];
        }
    }
}

ObjectSplit ObjectBins::best() const
{
    ObjectSplit best;
    for (int axis = 0; axis < 3; ++axis)
        if (m_scale[axis] > 0.0f)
            search(axis, best);
    return best;
}

void ObjectBins::search(int axis, ObjectSplit& best) const
{
    std::array<Box, numBins> above;
    std::array<uint32_t, numBins> numAbove;
    Box box = Box::empty();
    uint32_t count = 0;
    for (int i = numBins - 1; i > 0; --i) {
        box.add(m_boxes[axis][i]);
        count += m_counts[axis][i];
        above[static_cast<std::size_t>(i)] = box;
        numAbove[static_cast<std::size_t>(i)] = count;
    }
    box = Box::empty();
    count = 0;
    for (int i = 1; i < numBins; ++i) {
        box.add(m_boxes[axis][i - 1]);
        count += m_counts[axis][i - 1];
        const auto index = static_cast<std::size_t>(i);
        const float cost = box.halfArea() * static_cast<float>(count)
            + above[index].halfArea() * static_cast<float>(numAbove[index]);
        if (cost < best.cost) // not where a side is empty: that is NaN
            best = { cost, axis, i, box, above[index] };
    }
}

}
