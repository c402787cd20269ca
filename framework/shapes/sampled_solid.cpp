#include "shapes/sampled_solid.h"
#include <cmath>
#include <glm/common.hpp>

namespace shapes {

SampledSolid::SampledSolid(const Solid& solid, float cellSize)
    : m_solid(solid)
    , m_cellSize(cellSize)
{
}

float SampledSolid::valueAt(const Lattice& point)
{
    const auto [entry, isNew] = m_values.try_emplace(keyOf(point), 0.0f);
    if (isNew)
        entry->second = solidAround(point).value(positionOf(point));
    return entry->second;
}

void SampledSolid::fill(const Lattice& point)
{
    m_values[keyOf(point)] = -0.05f * m_cellSize; // not so little that vertices around the point coincide
}

const Solid& SampledSolid::solidAround(const Lattice& point)
{
    // Only a few limbs matter around a place: they are picked once for a block of cells.
    constexpr int pointsInBlock = 8;
    const Lattice block { glm::floor(glm::vec3(point) / static_cast<float>(pointsInBlock)) };
    const auto [entry, isNew] = m_solidOfBlock.try_emplace(keyOf(block));
    if (isNew) {
        const float size = m_cellSize * pointsInBlock;
        const float margin = 3.0f * m_cellSize; // more than the diagonal of a cell that the surface cuts
        entry->second = m_solid.near(size * (glm::vec3(block) + 0.5f), 0.5f * std::sqrt(3.0f) * size + margin);
    }
    return entry->second;
}

}
