#pragma once
#include "accel/wide/box_ray.h"
#include "accel/wide/shaft.h"
#include "accel/wide/slope_range.h"
#include "accel/wide/triangle_ray.h"

namespace accel::wide {

// A shaft as the tests want it: for boxes and triangles that none of its segments meets.
template <typename Simd> class ShaftTest {
    using Register = typename Simd::Register;
    using Boxes = typename Simd::Floats;
    using Triangles = typename Register::Floats;

public:
    ShaftTest(const View& tree, const Shaft& shaft)
        : m_shaft(shaft)
        , m_length(__builtin_fabsf(shaft.end))
        , m_forward(shaft.end < 0.0f ? -1.0f : 1.0f)
        , m_margin(4 * Slabs<Simd>::marginOf(tree, Slabs<Simd>::load(shaft.point))) // a ray's, and the roundings here
    {
        float origin[3];
        for (int i = 0; i < 3; ++i)
            origin[i] = shaft.point[shaft.axes[i]];
        float least[2], largest[2];
        for (int i = 0; i < 2; ++i) {
            constexpr float rounding = 0x1p-22f; // of the ray's slopes, and of who asked whether they are within
            least[i] = shaft.least[i] - rounding;
            largest[i] = shaft.largest[i] + rounding;
        }
        m_slopes = SlopeRange<Register>(shaft.axes, origin, least, largest);
    }

    // Whether the product of any three numbers is finite: the margin is some 2^-18 of the largest.
    [[nodiscard]] bool isReliable() const { return m_margin < 0x1p20f; }

    // Which of the node's boxes a segment may meet.
    [[nodiscard]] unsigned mayMeet(const Node& node) const
    {
        const Boxes zero = Simd::broadcast(0.0f), end = Simd::broadcast(m_shaft.end);
        const Boxes from = Simd::max(bound(node, 2, 0), Simd::min(zero, end));
        const Boxes to = Simd::min(bound(node, 2, 1), Simd::max(zero, end));
        unsigned boxes = Simd::lessEqual(from, to);
        for (int axis = 0; axis < 2; ++axis) {
            const Boxes a = Simd::broadcast(m_shaft.least[axis]), b = Simd::broadcast(m_shaft.largest[axis]);
            const Boxes least = Simd::min(Simd::min(a * from, a * to), Simd::min(b * from, b * to));
            const Boxes largest = Simd::max(Simd::max(a * from, a * to), Simd::max(b * from, b * to));
            boxes &= Simd::lessEqual(bound(node, axis, 0), largest) & Simd::lessEqual(least, bound(node, axis, 1));
        }
        return boxes;
    }

    // Whether a segment may meet one of the block's triangles.
    [[nodiscard]] bool mayMeet(const Block& block) const
    {
        for (int first = 0; first < width && block.primitives[first] != Hit::none; first += Register::size)
            if (partMayMeet(block, first))
                return true;
        return false;
    }

private:
    // Triangles seen from the point, in the shaft's axes and forward.
    struct Seen {
        Triangles corners[3][3]; // axis, corner
        Triangles nearest, farthest; // of the corners, along z
    };

    [[nodiscard]] bool partMayMeet(const Block& block, int first) const
    {
        const Seen seen = see(block, first);
        const unsigned all = Register::lessEqual(seen.nearest, seen.farthest); // not a number where there is none
        unsigned missed = areBeside(seen);
        if ((all & ~missed) != 0)
            missed |= areOnOneSide(block, first, seen);
        return (all & ~missed) != 0 && (m_slopes.partMayMeet(block, first) & ~missed) != 0;
    }

    // Of a box, seen from the point, with its margin. side: 0 the lower, 1 the upper.
    [[nodiscard]] Boxes bound(const Node& node, int axis, int side) const
    {
        const unsigned inSpace = m_shaft.axes[axis];
        const float margin = side == 0 ? m_margin : -m_margin;
        return Simd::load(node.bounds[inSpace][side]) - Simd::broadcast(m_shaft.point[inSpace] + margin);
    }

    [[nodiscard]] Seen see(const Block& block, int first) const
    {
        Seen seen;
        const Triangles forward = Register::broadcast(m_forward);
        for (int axis = 0; axis < 3; ++axis) {
            const unsigned inSpace = m_shaft.axes[axis];
            const Triangles point = Register::broadcast(m_shaft.point[inSpace] * m_forward);
            for (int corner = 0; corner < 3; ++corner)
                seen.corners[axis][corner] = Register::multiplySubtract(
                    Register::load(&block.positions[inSpace][corner][first]), forward, point);
        }
        seen.nearest = leastOf(seen.corners[2]);
        seen.farthest = mostOf(seen.corners[2]);
        return seen;
    }

    // Which triangles are on the outer side of one of the shaft's four. Backwards its segments would leave it; slopes
    // differ by 2 at most.
    [[nodiscard]] unsigned areBeside(const Seen& seen) const
    {
        const Triangles zero = Register::broadcast(0.0f), two = Register::broadcast(2.0f);
        const Triangles margin = Register::broadcast(m_margin) - two * Register::min(seen.nearest, zero);
        unsigned triangles = 0;
        for (int axis = 0; axis < 2; ++axis) {
            const Triangles least = Register::broadcast(m_shaft.least[axis]);
            const Triangles largest = Register::broadcast(m_shaft.largest[axis]);
            Triangles before[3], beyond[3];
            for (int corner = 0; corner < 3; ++corner) {
                before[corner] = Register::multiplySubtract(least, seen.corners[2][corner], seen.corners[axis][corner]);
                beyond[corner]
                    = Register::multiplySubtract(largest, seen.corners[2][corner], seen.corners[axis][corner]);
            }
            triangles |= Register::less(margin, leastOf(before)) | Register::less(mostOf(beyond), zero - margin);
        }
        return triangles;
    }

    static Triangles leastOf(const Triangles (&a)[3]) { return Register::min(Register::min(a[0], a[1]), a[2]); }
    static Triangles mostOf(const Triangles (&a)[3]) { return Register::max(Register::max(a[0], a[1]), a[2]); }

    // Of which triangles all segments stay on one side of the plane, as each would find: its distance is the plane's
    // height, over how fast the ray climbs towards it, but within what the corners allow.
    [[nodiscard]] unsigned areOnOneSide(const Block& block, int first, const Seen& seen) const
    {
        Triangles corners[3][3];
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                corners[corner][axis] = Register::load(&block.positions[axis][corner][first]);
        const TrianglePlane<Register> plane(corners[0], corners[1], corners[2], m_shaft.point);
        const unsigned* const axes = m_shaft.axes;
        const Triangles x = plane.normal[axes[0]], y = plane.normal[axes[1]], z = plane.normal[axes[2]];

        // How far segments climb until the shaft's end. The distance of a ray has a dozen roundings at most.
        const Triangles climb
            = (x * m_slopes.middle(0) + y * m_slopes.middle(1) + z) * Register::broadcast(m_shaft.end);
        const Triangles length = Register::broadcast(m_length);
        const Triangles rounding = (size(x) + size(y) + size(z)) * length * Register::broadcast(0x1p-18f);
        const Triangles reach = (size(x) * m_slopes.reach(0) + size(y) * m_slopes.reach(1)) * length + rounding;

        const unsigned beginBehind = Register::less(seen.nearest, Register::broadcast(-0x1p-100f));
        const unsigned endBeyond = Register::less(Register::broadcast(m_length * (1.0f + 0x1p-18f)), seen.farthest);
        const Triangles zero = Register::broadcast(0.0f);
        const unsigned haveDigits = Register::less(Register::broadcast(0x1p-60f), size(x) + size(y) + size(z));
        const auto areBelow = [&](Triangles height, Triangles least, Triangles most) {
            return haveDigits & Register::less(rounding * Register::broadcast(0x1p-60f), height) // no quotient is 0
                & Register::less(most, height) & (beginBehind | Register::less(zero, least))
                & (endBeyond | Register::less(most, zero));
        };
        return areBelow(plane.height, climb - reach, climb + reach)
            | areBelow(zero - plane.height, zero - climb - reach, reach - climb);
    }

    static Triangles size(Triangles a) { return Register::max(a, Register::broadcast(0.0f) - a); }

    const Shaft& m_shaft;
    float m_length, m_forward, m_margin;
    SlopeRange<Register> m_slopes;
};

}
