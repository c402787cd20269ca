#pragma once
#include "accel/wide/node.h"
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace accel::wide {

// Eight floats in two registers of four, in the compiler's own vectors: SSE and NEON alike.
struct Halves4 {
    using Half = float __attribute__((vector_size(16)));
    struct Floats {
        Half low, high;
        friend Floats operator+(Floats a, Floats b) { return { a.low + b.low, a.high + b.high }; }
        friend Floats operator-(Floats a, Floats b) { return { a.low - b.low, a.high - b.high }; }
        friend Floats operator*(Floats a, Floats b) { return { a.low * b.low, a.high * b.high }; }
        friend Floats operator/(Floats a, Floats b) { return { a.low / b.low, a.high / b.high }; }
    };

    static Floats load(const float* p)
    {
        const auto* halves = reinterpret_cast<const AnyHalf*>(p);
        return { halves[0], halves[1] };
    }
    static void store(float* p, Floats a)
    {
        auto* halves = reinterpret_cast<AnyHalf*>(p);
        halves[0] = a.low;
        halves[1] = a.high;
    }
    static Floats broadcast(float a) { return { Half {} + a, Half {} + a }; }
    static Floats multiplySubtract(Floats a, Floats b, Floats c) { return a * b - c; }
    static Floats min(Floats a, Floats b)
    {
        return { a.low < b.low ? a.low : b.low, a.high < b.high ? a.high : b.high };
    }
    static Floats max(Floats a, Floats b)
    {
        return { a.low > b.low ? a.low : b.low, a.high > b.high ? a.high : b.high };
    }
    static unsigned lessEqual(Floats a, Floats b) { return bits(a.low <= b.low) | bits(a.high <= b.high) << 4; }
    static unsigned less(Floats a, Floats b) { return bits(a.low < b.low) | bits(a.high < b.high) << 4; }

    // A bit for each of four.
    static unsigned signs(Half a) { return bits(reinterpret_cast<Mask>(a) < 0); }

    // The highest bits of eight.
    static unsigned topBits(const uint32_t* p)
    {
        const Floats a = load(reinterpret_cast<const float*>(p));
        return signs(a.low) | signs(a.high) << 4;
    }

private:
    using AnyHalf = float __attribute__((vector_size(16), may_alias));
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
