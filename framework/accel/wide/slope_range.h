#pragma once
#include "accel/wide/node.h"

namespace accel::wide {

// Rays from one point by slopes within a rectangle, as the test of triangles wants them: all at once, for triangles
// that none of them meets. The same axis of space becomes z for all, as it does for each: Woop, Benthin, Wald 2013.
template <typename Simd> class SlopeRange {
    using Floats = typename Simd::Floats;

public:
    SlopeRange() = default;

    // Of space, the axes that become x, y, z, and the rays' origin along these; x / z and y / z, which are 1 at most in
    // size, with whatever the rays' own were rounded by.
    SlopeRange(const unsigned (&axes)[3], const float (&origin)[3], const float (&least)[2], const float (&largest)[2])
    {
        for (int i = 0; i < 3; ++i) {
            m_axes[i] = axes[i];
            m_origin[i] = origin[i];
        }
        for (int i = 0; i < 2; ++i) {
            m_middle[i] = 0.5f * (least[i] + largest[i]);
            m_reach[i] = 0.5f * (largest[i] - least[i]) + 4 * unit; // the rounding of both
        }
    }

    // Of x / z or y / z: the middle, and how far a slope may be from it.
    [[nodiscard]] Floats middle(int axis) const { return Simd::broadcast(m_middle[axis]); }
    [[nodiscard]] Floats reach(int axis) const { return Simd::broadcast(m_reach[axis]); }

    // Which triangles of a block a ray may meet: all that one does, perhaps others.
    [[nodiscard]] unsigned mayMeet(const Block& block) const
    {
        unsigned triangles = 0;
        for (int first = 0; first < width; first += Simd::size)
            triangles |= partMayMeet(block, first) << first;
        return triangles;
    }

    // The same of as many as a register has places, from the first.
    //
    // A weight is a linear function of the two slopes: known in the middle, and by how much it differs within reach. If
    // two have different signs throughout, no ray passes between the edges. Each ray's own weights are rounded by at
    // most 10 units of the product of the corners' sizes, and these here by as much; unless numbers are so small that
    // they have fewer digits, or so large that the product of some is infinite.
    [[nodiscard]] unsigned partMayMeet(const Block& block, int first) const
    {
        Floats c[3][3], largest = Simd::broadcast(0.0f); // axis, corner
        for (unsigned axis = 0; axis < 3; ++axis)
            for (int corner = 0; corner < 3; ++corner)
                c[axis][corner]
                    = Simd::load(&block.positions[m_axes[axis]][corner][first]) - Simd::broadcast(m_origin[axis]);
        for (int i = 0; i < 3; ++i)
            largest = Simd::max(largest, size(c[0][i]) + size(c[1][i]) + size(c[2][i]));
        const Floats rounding = largest * largest * Simd::broadcast(32 * unit) + Simd::broadcast(0x1p-120f);
        Floats lower[3], upper[3];
        for (int i = 0; i < 3; ++i) {
            const int a = (i + 1) % 3, b = (i + 2) % 3;
            const Floats normalX = c[1][b] * c[2][a] - c[2][b] * c[1][a];
            const Floats normalY = c[2][b] * c[0][a] - c[0][b] * c[2][a];
            const Floats normalZ = c[0][b] * c[1][a] - c[1][b] * c[0][a];
            const Floats weight = normalX * middle(0) + normalY * middle(1) + normalZ;
            const Floats apart = size(normalX) * reach(0) + size(normalY) * reach(1) + rounding;
            lower[i] = weight - apart;
            upper[i] = weight + apart;
        }
        const Floats zero = Simd::broadcast(0.0f);
        const Floats leastUpper = Simd::min(Simd::min(upper[0], upper[1]), upper[2]);
        const Floats mostLower = Simd::max(Simd::max(lower[0], lower[1]), lower[2]);
        return Simd::lessEqual(zero, leastUpper) | Simd::lessEqual(mostLower, zero)
            | Simd::lessEqual(Simd::broadcast(0x1p100f), rounding);
    }

private:
    static constexpr float unit = 0x1p-24f; // the largest relative error of one rounding

    static Floats size(Floats a) { return Simd::max(a, Simd::broadcast(0.0f) - a); }

    unsigned m_axes[3];
    float m_origin[3], m_middle[2], m_reach[2];
};

}
