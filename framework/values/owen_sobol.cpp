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

    // Sobol's second dimension of what is the first's: its matrix is Pascal's triangle modulo 2, the fifth power (by
    // Kronecker) of the one of two digits.
    uint32_t secondOfSobol(uint32_t digits)
    {
        digits ^= (digits & 0xaaaaaaaau) >> 1;
        digits ^= (digits & 0xccccccccu) >> 2;
        digits ^= (digits & 0xf0f0f0f0u) >> 4;
        digits ^= (digits & 0xff00ff00u) >> 8;
        return digits ^ digits >> 16;
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
        return static_cast<float>(reverseBits(digits) >> 8) * 0x1p-24f;
    }

}

// A number's digits after the point stand in order from the lowest bit on, so that flipUpwards lets each depend on
// those before it: what lay in one half of an interval lies in one half again. The first of Sobol's dimensions has the
// digits of the index, and its order is scrambled as a number is whose last digit comes first.
glm::vec2 owenSobol(uint32_t index, uint32_t seed)
{
    const uint32_t orderSeed = hash(seed + 1), xSeed = hash(orderSeed + 1), ySeed = hash(xSeed + 1); // hash(0) is 0
    const uint32_t digits = reverseBits(flipUpwards(reverseBits(index), orderSeed));
    return { toFloat(flipUpwards(digits, xSeed)), toFloat(flipUpwards(secondOfSobol(digits), ySeed)) };
}

}
