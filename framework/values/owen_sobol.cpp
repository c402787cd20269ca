#include "values/owen_sobol.h"

namespace values {
namespace {

    uint32_t reverseBits(uint32_t x)
    {
        x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
        x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
        x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
        return __builtin_bswap32(x);
    }

    // Each bit is flipped or not by a hash of the bits below it: Laine and Karras 2011, "Stratified Sampling for
    // Stochastic Transparency", with the numbers of Vegdahl 2021.
    uint32_t flipUpwards(uint32_t x, uint32_t seed)
    {
        x ^= x * 0x3d20adeau;
        x += seed;
        x *= seed >> 16 | 1;
        x ^= x * 0x05526c56u;
        x ^= x * 0x53a22864u;
        return x;
    }

    // Each digit depends on those before it: what lay in one half of an interval lies in one half again.
    uint32_t scramble(uint32_t x, uint32_t seed)
    {
        return reverseBits(flipUpwards(reverseBits(x), seed));
    }

    // Sobol's second dimension: its primitive polynomial is x + 1. The first is van der Corput's sequence.
    uint32_t secondOfSobol(uint32_t index)
    {
        uint32_t digits = 0;
        for (uint32_t direction = 1u << 31; index != 0; index >>= 1, direction ^= direction >> 1)
            if (index & 1)
                digits ^= direction;
        return digits;
    }

    // Mixes bits: the finaliser of MurmurHash3, Appleby 2011.
    uint32_t hash(uint32_t x)
    {
        x = (x ^ x >> 16) * 0x85ebca6bu;
        x = (x ^ x >> 13) * 0xc2b2ae35u;
        return x ^ x >> 16;
    }

    float toFloat(uint32_t digits)
    {
        return static_cast<float>(digits >> 8) * 0x1p-24f;
    }

}

glm::vec2 owenSobol(uint32_t index, uint32_t seed)
{
    const uint32_t orderSeed = hash(seed + 1), xSeed = hash(orderSeed + 1), ySeed = hash(xSeed + 1); // hash(0) is 0
    index = scramble(index, orderSeed);
    return { toFloat(scramble(reverseBits(index), xSeed)), toFloat(scramble(secondOfSobol(index), ySeed)) };
}

}
