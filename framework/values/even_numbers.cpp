#include "values/even_numbers.h"
#include "values/owen_sobol.h"

namespace values {

void EvenNumbers::startRay(uint32_t ray)
{
    m_ray = ray;
    m_numPurposes = 1; // the first is where in the pixel the rays begin, asked for before there are rays
    m_numbers = m_points = {};
}

void EvenNumbers::expectNumbers(uint32_t number)
{
    m_numbers = purposeOf(number);
}

void EvenNumbers::expectPoints(uint32_t number)
{
    m_points = purposeOf(number);
}

float EvenNumbers::next1d()
{
    return next(m_numbers).x;
}

glm::vec2 EvenNumbers::next2d()
{
    return next(m_points);
}

// The same in each ray for the same purpose.
uint32_t EvenNumbers::newSeed()
{
    return m_seed * 0x9e3779b9u + m_numPurposes++; // owenSobol mixes it
}

EvenNumbers::Purpose EvenNumbers::purposeOf(uint32_t number)
{
    return { newSeed(), m_ray * number, number };
}

glm::vec2 EvenNumbers::next(Purpose& expected)
{
    if (expected.numLeft == 0)
        return owenSobol(m_ray, newSeed());
    --expected.numLeft;
    return owenSobol(expected.index++, expected.seed);
}

}
