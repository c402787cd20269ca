#pragma once
#include "shapes/lattice.h"
#include "shapes/solid.h"
#include <unordered_map>

namespace shapes {

// The values of a solid at the points of a lattice, each computed once and only where somebody asks.
class SampledSolid {
public:
    SampledSolid(const Solid& solid, float cellSize);

    [[nodiscard]] float cellSize() const { return m_cellSize; }
    [[nodiscard]] glm::vec3 positionOf(const Lattice& point) const { return m_cellSize * glm::vec3(point); }
    [[nodiscard]] float valueAt(const Lattice& point);
    [[nodiscard]] bool isInside(const Lattice& point) { return valueAt(point) < 0.0f; }

    // From now on the point is just inside.
    void fill(const Lattice& point);

    // What of the solid shapes the surface around the point.
    [[nodiscard]] const Solid& solidAround(const Lattice& point);

private:
    Solid m_solid;
    float m_cellSize;
    std::unordered_map<uint64_t, float> m_values;
    std::unordered_map<uint64_t, Solid> m_solidOfBlock;
};

}
