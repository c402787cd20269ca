#pragma once
#include "accel/wide/triangles.h"
#include <optional>
#include <span>

namespace accel::wide {

struct ObjectSplit;
struct SpatialSplit;

// Some of the triangles, on the way to become a subtree.
struct Subtree {
    // A place in the array of references: some in use, then room for parts of those that are cut.
    uint32_t first, count, capacity;
    Box box;
    uint32_t depth;
};

struct Sides {
    Subtree lower, upper;
};

// Divides subtrees in two by the surface area heuristic, and cuts in space where that pays. The same for any number of
// threads.
class Splitter {
public:
    Splitter(const Triangles& triangles, Reference* references, float rootArea)
        : m_triangles(triangles)
        , m_references(references)
        , m_rootArea(rootArea)
    {
    }

    // Of two references or more. Reorders them.
    [[nodiscard]] Sides split(const Subtree& subtree) const;

    [[nodiscard]] const Triangles& triangles() const { return m_triangles; }
    [[nodiscard]] std::span<Reference> references(uint32_t first, uint32_t count) const
    {
        return { m_references + first, count };
    }
    [[nodiscard]] std::span<Reference> in(const Subtree& subtree) const
    {
        return references(subtree.first, subtree.count);
    }

private:
    [[nodiscard]] SpatialSplit findSpatial(const Subtree& subtree, const ObjectSplit& objects) const;
    [[nodiscard]] std::optional<Sides> splitSpace(const Subtree& subtree, const SpatialSplit& split) const;
    [[nodiscard]] Sides splitInHalves(const Subtree& subtree) const;
    [[nodiscard]] Sides arrange(const Subtree& subtree, uint32_t numLower, const Box& lower, const Box& upper) const;

    const Triangles& m_triangles;
    Reference* m_references;
    float m_rootArea;
};

}
