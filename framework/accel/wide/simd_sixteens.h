#pragma once
#include <cstdint>
#include <immintrin.h>

namespace accel::wide {

// Sixteen floats in a register of AVX-512. min and max return the second operand if one is not a number; they name a
// mask of all places since g++ 12 warns of its own header without one.
struct Sixteens {
    using Floats = __m512; // the compiler knows + - * /
    using Register = Sixteens;
    static constexpr int size = 16;

    static Floats load(const float* p) { return _mm512_load_ps(p); }
    static void store(float* p, Floats a) { _mm512_store_ps(p, a); }
    static Floats broadcast(float a) { return _mm512_set1_ps(a); }

    // a * b - c, rounded once or twice.
    static Floats multiplySubtract(Floats a, Floats b, Floats c) { return _mm512_fmsub_ps(a, b, c); }

    static Floats min(Floats a, Floats b) { return _mm512_maskz_min_ps(all, a, b); }
    static Floats max(Floats a, Floats b) { return _mm512_maskz_max_ps(all, a, b); }

    // A bit for each place, the first the lowest.
    static unsigned lessEqual(Floats a, Floats b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ); }
    static unsigned less(Floats a, Floats b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }

    // The highest bits of as many.
    static unsigned topBits(const uint32_t* p) { return _mm512_movepi32_mask(_mm512_load_si512(p)); }

    // A bit for each of four.
    static unsigned signs(__m128 a) { return static_cast<unsigned>(_mm_movemask_ps(a)); }

private:
    static constexpr __mmask16 all = 0xffff;
};

}
