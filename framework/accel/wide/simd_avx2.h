#pragma once
#include "accel/wide/node.h"
#include <immintrin.h>

namespace accel::wide {

// Eight floats in one register. min and max return the second operand if one is not a number.
struct Avx2 {
    using Floats = __m256; // the compiler knows + - * /

    static Floats load(const float* p) { return _mm256_load_ps(p); }
    static void store(float* p, Floats a) { _mm256_store_ps(p, a); }
    static Floats broadcast(float a) { return _mm256_set1_ps(a); }
    static Floats multiplySubtract(Floats a, Floats b, Floats c)
    {
        return _mm256_fmsub_ps(a, b, c);
    } // rounded once or twice
    static Floats min(Floats a, Floats b) { return _mm256_min_ps(a, b); }
    static Floats max(Floats a, Floats b) { return _mm256_max_ps(a, b); }

    // A bit for each place, the first the lowest.
    static unsigned lessEqual(Floats a, Floats b) { return bits(_mm256_cmp_ps(a, b, _CMP_LE_OQ)); }
    // A bit for each of four.
    static unsigned signs(__m128 a) { return static_cast<unsigned>(_mm_movemask_ps(a)); }

    // Writes the children in the mask to where there is room for all.
    static void pack(unsigned mask, const Child* children, Child* to)
    {
        const uint64_t spread = _pdep_u64(mask, 0x0101010101010101u) * 0xff;
        const uint64_t places = _pext_u64(0x0706050403020100u, spread);
        const __m256i order = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(places)));
        const __m256i all = _mm256_load_si256(reinterpret_cast<const __m256i*>(children));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(all, order));
    }

    static unsigned less(Floats a, Floats b) { return bits(_mm256_cmp_ps(a, b, _CMP_LT_OQ)); }

private:
    static unsigned bits(Floats mask) { return static_cast<unsigned>(_mm256_movemask_ps(mask)); }
};

}
