#include "sampler.h"
#include "values/even_numbers.h"

float Sampler::nextEven1d()
{
    return m_even->next1d();
}

glm::vec2 Sampler::nextEven2d()
{
    return m_even->next2d();
}
