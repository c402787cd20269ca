#pragma once
#include <cstdint>
#include <immintrin.h>

namespace accel::wide {

// Eight floats in a register of AVX2. min and max return the second operand if one is not a number.
struct Eights {
    using Floats = __m256; // the compiler knows + - * /
    using Register = Eights;
    static constexpr int size = 8;

    static Floats load(const float* p) { return _mm256_load_ps(p); }
    static void store(float* p, Floats a) { _mm256_store_ps(p, a); }
    static Floats broadcast(float a) { return _mm256_set1_ps(a); }
    static Floats multiplySubtract(Floats a, Floats b, Floats c) { return _mm256_fmsub_ps(a, b, c); }
    static Floats min(Floats a, Floats b) { return _mm256_min_ps(a, b); }
    static Floats max(Floats a, Floats b) { return _mm256_max_ps(a, b); }
    static unsigned lessEqual(Floats a, Floats b) { return bits(_mm256_cmp_ps(a, b, _CMP_LE_OQ)); }
    static unsigned less(Floats a, Floats b) { return bits(_mm256_cmp_ps(a, b, _CMP_LT_OQ)); }
    static unsigned topBits(const uint32_t* p) { return bits(load(reinterpret_cast<const float*>(p))); }
    static unsigned signs(__m128 a) { return static_cast<unsigned>(_mm_movemask_ps(a)); }

private:
    static unsigned bits(Floats mask) { return static_cast<unsigned>(_mm256_movemask_ps(mask)); }
};

}
