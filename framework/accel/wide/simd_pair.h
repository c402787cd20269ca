#pragma once
#include <cstdint>

namespace accel::wide {

// Twice as many floats as a register has.
template <typename Half> struct Pair {
    struct Floats {
        typename Half::Floats low, high;
        friend Floats operator+(Floats a, Floats b) { return { a.low + b.low, a.high + b.high }; }
        friend Floats operator-(Floats a, Floats b) { return { a.low - b.low, a.high - b.high }; }
        friend Floats operator*(Floats a, Floats b) { return { a.low * b.low, a.high * b.high }; }
        friend Floats operator/(Floats a, Floats b) { return { a.low / b.low, a.high / b.high }; }
    };
    using Register = typename Half::Register;
    static constexpr int size = 2 * Half::size;

    static Floats load(const float* p) { return { Half::load(p), Half::load(p + Half::size) }; }
    static void store(float* p, Floats a)
    {
        Half::store(p, a.low);
        Half::store(p + Half::size, a.high);
    }
    static Floats broadcast(float a) { return { Half::broadcast(a), Half::broadcast(a) }; }
    static Floats multiplySubtract(Floats a, Floats b, Floats c)
    {
        return { Half::multiplySubtract(a.low, b.low, c.low), Half::multiplySubtract(a.high, b.high, c.high) };
    }
    static Floats min(Floats a, Floats b) { return { Half::min(a.low, b.low), Half::min(a.high, b.high) }; }
    static Floats max(Floats a, Floats b) { return { Half::max(a.low, b.low), Half::max(a.high, b.high) }; }
    static unsigned lessEqual(Floats a, Floats b)
    {
        return join(Half::lessEqual(a.low, b.low), Half::lessEqual(a.high, b.high));
    }
    static unsigned less(Floats a, Floats b) { return join(Half::less(a.low, b.low), Half::less(a.high, b.high)); }
    static unsigned topBits(const uint32_t* p) { return join(Half::topBits(p), Half::topBits(p + Half::size)); }
    template <typename Float4> static unsigned signs(Float4 a) { return Half::signs(a); }

private:
    static unsigned join(unsigned low, unsigned high) { return low | high << Half::size; }
};

}
