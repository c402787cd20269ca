#pragma once
#include <cstdint>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace accel::wide {

// Four floats in the compiler's own vectors: SSE and NEON alike. min and max return the second operand if one is not a
// number.
struct Fours {
    using Floats = float __attribute__((vector_size(16)));
    using Register = Fours;
    static constexpr int size = 4;

    static Floats load(const float* p) { return *reinterpret_cast<const AnyFloats*>(p); }
    static void store(float* p, Floats a) { *reinterpret_cast<AnyFloats*>(p) = a; }
    static Floats broadcast(float a) { return Floats {} + a; }
    static Floats multiplySubtract(Floats a, Floats b, Floats c) { return a * b - c; }
    static Floats min(Floats a, Floats b) { return a < b ? a : b; }
    static Floats max(Floats a, Floats b) { return a > b ? a : b; }
    static unsigned lessEqual(Floats a, Floats b) { return bits(a <= b); }
    static unsigned less(Floats a, Floats b) { return bits(a < b); }
    static unsigned topBits(const uint32_t* p) { return signs(load(reinterpret_cast<const float*>(p))); }
    static unsigned signs(Floats a) { return bits(reinterpret_cast<Mask>(a) < 0); }

private:
    using AnyFloats = float __attribute__((vector_size(16), may_alias));
    using Mask = int __attribute__((vector_size(16))); // 0 or -1

    static unsigned bits(Mask mask)
    {
#ifdef __SSE2__
        return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
        const Mask weighted = mask & Mask { 1, 2, 4, 8 };
        return static_cast<unsigned>(weighted[0] | weighted[1] | weighted[2] | weighted[3]);
#endif
    }
};

}
