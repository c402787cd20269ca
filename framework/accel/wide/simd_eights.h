#pragma once
#include "accel/wide/node.h"
#include <immintrin.h>

namespace accel::wide {

// Eight floats in one register, or in half of one with AVX-512, whose comparisons give masks by themselves: nodes and
// blocks have no more. min and max return the second operand if one is not a number.
template <bool hasMasks> struct Eights {
    using Floats = __m256; // the compiler knows + - * /

    static Floats load(const float* p) { return _mm256_load_ps(p); }
    static void store(float* p, Floats a) { _mm256_store_ps(p, a); }
    static Floats broadcast(float a) { return _mm256_set1_ps(a); }

    // a * b - c, rounded once or twice.
    static Floats multiplySubtract(Floats a, Floats b, Floats c) { return _mm256_fmsub_ps(a, b, c); }

    static Floats min(Floats a, Floats b) { return _mm256_min_ps(a, b); }
    static Floats max(Floats a, Floats b) { return _mm256_max_ps(a, b); }

    // A bit for each place, the first the lowest.
    static unsigned lessEqual(Floats a, Floats b) { return compare<_CMP_LE_OQ>(a, b); }
    static unsigned less(Floats a, Floats b) { return compare<_CMP_LT_OQ>(a, b); }

    // A bit for each of four.
    static unsigned signs(__m128 a) { return static_cast<unsigned>(_mm_movemask_ps(a)); }

    // The highest bits of eight.
    static unsigned topBits(const uint32_t* p) { return bits(load(reinterpret_cast<const float*>(p))); }

private:
    template <int predicate> static unsigned compare(Floats a, Floats b)
    {
        if constexpr (hasMasks)
            return _mm256_cmp_ps_mask(a, b, predicate);
        else
            return bits(_mm256_cmp_ps(a, b, predicate));
    }

    static unsigned bits(Floats mask) { return static_cast<unsigned>(_mm256_movemask_ps(mask)); }
};

}
