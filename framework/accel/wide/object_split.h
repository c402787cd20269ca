#pragma once
#include "accel/wide/box.h"
#include <span>

namespace accel::wide {

// A plane between two sets of references, by the surface area heuristic: MacDonald and Booth 1990, with bins: Wald
// 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies".
struct ObjectSplit {
    float cost = std::numeric_limits<float>::infinity(); // half areas times references of both sides
    int axis = -1; // none
    int bin = 0; // the first of the upper side
    Box lower, upper; // what the sides cover
};

class ObjectBins {
public:
    // centroids: the box of all doubled centroids of so many references, which are yet to be added.
    ObjectBins(const Box& centroids, std::size_t numReferences);
    void add(std::span<const Reference> references);
    void add(const ObjectBins& other); // of the same box

    [[nodiscard]] ObjectSplit best() const;
    [[nodiscard]] bool isBelow(const Reference& reference, const ObjectSplit& split) const
    {
        return binOf(reference.doubledCentroid())[split.axis] < split.bin;
    }

private:
    using Int4 = int __attribute__((vector_size(16)));

    [[nodiscard]] Int4 binOf(Float4 doubledCentroid) const
    {
        return __builtin_convertvector((doubledCentroid - m_origin) * m_scale, Int4);
    }

    static constexpr int maxBins = 16;

    void search(int axis, ObjectSplit& best) const;

    int m_numBins;
    Float4 m_origin, m_scale;
    Box m_boxes[3][maxBins];
    uint32_t m_counts[3][maxBins];
};

}
