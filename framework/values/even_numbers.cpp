#include "values/even_numbers.h"
#include "values/owen_sobol.h"
#include <algorithm>
#include <cmath>

namespace values {
namespace {

    // Below 1, also after rounding.
    float inCell(uint32_t cell, uint32_t numCells, float x)
    {
        return std::min((static_cast<float>(cell) + x) / static_cast<float>(numCells), 1.0f - 0x1p-24f);
    }

}

void EvenNumbers::startRay(uint32_t ray)
{
    m_ray = m_firstRay + ray;
    m_numPurposes = 1; // the first is where in the pixel the rays begin, asked for before there are rays
    m_numbers = m_points = {};
}

void EvenNumbers::expectNumbers(uint32_t number)
{
    m_numbers = newPurpose(number);
}

void EvenNumbers::expectPoints(uint32_t number)
{
    m_points = newPurpose(number);
}

float EvenNumbers::next1d()
{
    if (m_numbers.numHad == m_numbers.number)
        return nextUnexpected().x;
    const uint32_t cell = m_numbers.numHad;
    const float x = nextOf(m_numbers).x;
    return m_method != Method::Jittered ? x : inCell(cell, m_numbers.number, x);
}

glm::vec2 EvenNumbers::next2d()
{
    if (m_points.numHad == m_points.number)
        return nextUnexpected();
    const uint32_t cell = m_points.numHad;
    const glm::vec2 point = nextOf(m_points);
    const auto side = static_cast<uint32_t>(std::sqrt(static_cast<double>(m_points.number)));
    if (m_method != Method::Jittered || cell >= side * side)
        return point;
    return { inCell(cell % side, side, point.x), inCell(cell / side, side, point.y) };
}

// The same in each ray for the same purpose.
uint32_t EvenNumbers::newSeed()
{
    return m_seed * 0x9e3779b9u + m_numPurposes++; // owenSobol mixes it
}

// Before there are rays, each number is another ray's.
EvenNumbers::Purpose EvenNumbers::newPurpose(uint32_t number)
{
    const uint32_t first = m_numPurposes == 0 ? m_ray : m_ray * number;
    return { newSeed(), first, number, 0 };
}

glm::vec2 EvenNumbers::nextOf(Purpose& purpose)
{
    return pointOf(purpose.first + purpose.numHad++, purpose.seed);
}

glm::vec2 EvenNumbers::nextUnexpected()
{
    return pointOf(m_ray, newSeed());
}

glm::vec2 EvenNumbers::pointOf(uint32_t index, uint32_t seed) const
{
    switch (m_method) {
    case Method::Owen:
        return owenSobol(index, seed);
    case Method::OwenPairs:
        return { owenSobol(index, seed).x, owenSobol(index, ~seed).x };
    case Method::Jittered:
        break;
    }
    return owenSobol(0, seed + index * 0x85ebca6bu);
}

}
