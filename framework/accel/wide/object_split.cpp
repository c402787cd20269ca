#include "accel/wide/object_split.h"
#include <algorithm>

namespace accel::wide {

ObjectBins::ObjectBins(const Box& centroids, std::size_t numReferences)
    : m_numBins(static_cast<int>(std::min<std::size_t>(maxBins, 4 + numReferences / 2))) // few need few
    , m_origin(centroids.lower)
{
    const Float4 extent = centroids.upper - centroids.lower;
    for (int axis = 0; axis < 4; ++axis) // a little less than all bins: the last centroid belongs to the last bin
        m_scale[axis]
            = axis < 3 && extent[axis] > 1e-30f ? 0.9999f * static_cast<float>(m_numBins) / extent[axis] : 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        std::fill_n(m_boxes[axis], m_numBins, Box::empty());
        std::fill_n(m_counts[axis], m_numBins, 0u);
    }
}

void ObjectBins::add(std::span<const Reference> references)
{
    for (const Reference& reference : references) {
        const Int4 bin = binOf(reference.doubledCentroid());
        for (int axis = 0; axis < 3; ++axis) {
            m_boxes[axis][bin[axis]].add(reference.box);
            ++m_counts[axis][bin[axis]];
        }
    }
}

void ObjectBins::add(const ObjectBins& other)
{
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < m_numBins; ++i) {
            m_boxes[axis][i].add(other.m_boxes[axis][i]);
            m_counts[axis][i] += other.m_counts[axis][i];
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
    std::array<Box, maxBins> above;
    std::array<uint32_t, maxBins> numAbove;
    Box box = Box::empty();
    uint32_t count = 0;
    for (int i = m_numBins - 1; i > 0; --i) {
        box.add(m_boxes[axis][i]);
        count += m_counts[axis][i];
        above[static_cast<std::size_t>(i)] = box;
        numAbove[static_cast<std::size_t>(i)] = count;
    }
    box = Box::empty();
    count = 0;
    for (int i = 1; i < m_numBins; ++i) {
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
