#pragma once
#include "accel/wide/slope_range.h"
#include "accel/wide/triangle_ray.h"

namespace accel::wide {

// Rays from one point, as the test of one triangle wants them: a register of rays at a time. The bits are those that
// each ray finds alone.
template <typename Simd> class TriangleBeam {
    using Floats = typename Simd::Floats;

public:
    TriangleBeam(const Ray* rays, unsigned count)
        : m_rays(rays)
        , m_count(count)
        , m_first(rays[0])
    {
        float least[2] = { m_first.x, m_first.y }, largest[2] = { m_first.x, m_first.y };
        for (unsigned i = 0; i < count; ++i) {
            const Shear<Simd> shear(rays[i]);
            m_isOne &= shear.axes[2] == m_first.axes[2] && areNumbers(shear);
            least[0] = shear.x < least[0] ? shear.x : least[0];
            least[1] = shear.y < least[1] ? shear.y : least[1];
            largest[0] = shear.x > largest[0] ? shear.x : largest[0];
            largest[1] = shear.y > largest[1] ? shear.y : largest[1];
            set(i, shear, rays[i]);
        }
        for (unsigned i = count; i % Simd::size != 0; ++i)
            set(i, m_first, rays[0]); // nobody looks at these
        m_slopes = SlopeRange<Simd>(m_first.axes, m_first.origin, least, largest);
    }

    // Whether they turn the same axis into z, as they must, by slopes that are numbers.
    [[nodiscard]] bool isOne() const { return m_isOne; }

    // Which triangles of a block a ray may meet: all that one does, perhaps others.
    [[nodiscard]] unsigned mayMeet(const Block& block) const { return m_slopes.mayMeet(block); }

    // For those of the rays, a bit for each, that meet the triangle within their limits: the hit becomes theirs and its
    // distance their limit, if it is closer.
    void findCloser(const Block& block, int triangle, uint64_t rays, Hit* hits, float* limits) const
    {
        const auto position = [&](unsigned axis, int corner) { return block.positions[axis][corner][triangle]; };
        Floats corners[3][3], places[3][3];
        for (unsigned axis = 0; axis < 3; ++axis)
            for (int corner = 0; corner < 3; ++corner) {
                corners[axis][corner] = Simd::broadcast(position(m_first.axes[axis], corner) - m_first.origin[axis]);
                places[corner][axis] = Simd::broadcast(position(axis, corner));
            }
        const TrianglePlane<Simd> plane(places[0], places[1], places[2], &m_rays[0].origin.x);
        for (unsigned first = 0; first < m_count; first += Simd::size) {
            const auto some = static_cast<unsigned>(rays >> first) & ((1u << Simd::size) - 1);
            if (some != 0)
                findCloserOfSome(block, triangle, corners, plane, first, some, hits, limits);
        }
    }

private:
    void set(unsigned ray, const Shear<Simd>& shear, const Ray& from)
    {
        m_shearX[ray] = shear.x;
        m_shearY[ray] = shear.y;
        m_scale[ray] = shear.scale;
        m_direction[0][ray] = from.direction.x;
        m_direction[1][ray] = from.direction.y;
        m_direction[2][ray] = from.direction.z;
    }

    static bool areNumbers(const Shear<Simd>& shear)
    {
        return __builtin_fabsf(shear.x) < 2.0f && __builtin_fabsf(shear.y) < 2.0f; // 1, but for rounding
    }

    void findCloserOfSome(const Block& block, int triangle, const Floats (&corners)[3][3],
        const TrianglePlane<Simd>& plane, unsigned first, unsigned some, Hit* hits, float* limits) const
    {
        const Sheared<Simd> s(corners, Simd::load(m_shearX + first), Simd::load(m_shearY + first));
        unsigned mask = s.candidates() & some;
        if (mask == 0)
            return;
        const Floats t = plane.distances(Simd::load(m_direction[0] + first), Simd::load(m_direction[1] + first),
            Simd::load(m_direction[2] + first), s, Simd::load(m_scale + first));
        mask &= Simd::lessEqual(Simd::broadcast(0.0f), t) & Simd::lessEqual(t, Simd::load(limits + first));
        if (mask == 0)
            return;
        const unsigned certain = s.certain();
        alignas(64) float ts[Simd::size], us[Simd::size], vs[Simd::size];
        Simd::store(ts, t);
        s.storeWeights(us, vs);
        for (; mask != 0; mask &= mask - 1) {
            const int i = __builtin_ctz(mask);
            const unsigned ray = first + static_cast<unsigned>(i);
            Closest<Simd> closest(hits[ray]);
            if (certain >> i & 1)
                closest.offer({ ts[i], block.primitives[triangle], us[i], vs[i] });
            else // a weight is zero: alone
                TriangleRay<Simd>(m_rays[ray]).findCloser(block, closest);
            hits[ray] = closest.hit;
            limits[ray] = closest.hit.t;
        }
    }

    const Ray* m_rays;
    unsigned m_count;
    Shear<Simd> m_first;
    bool m_isOne = true;
    SlopeRange<Simd> m_slopes;
    alignas(64) float m_shearX[mostRays], m_shearY[mostRays], m_scale[mostRays], m_direction[3][mostRays];
};

}
