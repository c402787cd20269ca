#pragma once
#include "accel/wide/sheared.h"

namespace accel::wide {

// What a ray knows of the closest hit so far; of one still to be found: the end of the ray, no primitive.
template <typename Simd> struct Closest {
    explicit Closest(const Ray& ray)
        : Closest(noneYet(ray))
    {
    }

    explicit Closest(const Hit& found)
        : limit(Simd::broadcast(found.t))
        , hit(found)
    {
    }

    static Hit noneYet(const Ray& ray) { return { ray.t, Hit::none, 0.0f, 0.0f }; }

    void offer(const Hit& other)
    {
        if (other.t < hit.t || (other.t == hit.t && other.primitive < hit.primitive))
            hit = other;
    }

    typename Simd::Floats limit; // hit.t
    Hit hit;
};

// A ray as the triangle test wants it.
template <typename Simd> class TriangleRay {
    using Floats = typename Simd::Floats;
    using Sheared = wide::Sheared<Simd>;

public:
    explicit TriangleRay(const Ray& ray)
        : TriangleRay(ray, Shear<Simd>(ray))
    {
    }

    TriangleRay(const Ray& ray, const Shear<Simd>& shear)
        : m_ray(ray)
        , m_shearX(Simd::broadcast(shear.x))
        , m_shearY(Simd::broadcast(shear.y))
        , m_scale(Simd::broadcast(shear.scale))
    {
        for (int i = 0; i < 3; ++i) {
            m_rows[i] = shear.axes[i] * sizeof(Block::positions[0]);
            m_origin[i] = Simd::broadcast(shear.origin[i]);
        }
    }

    // Whether a triangle of the block is met within the limit. Where most blocks have none that the ray passes through,
    // at any distance, it pays to stop at that; where a tree has chosen the blocks, it is one more jump to foresee.
    template <bool mostHaveNone> [[nodiscard]] bool meets(const Block& block, float limit) const
    {
        for (int first = 0; hasTriangles(block, first); first += Simd::size)
            if (meetsPart<mostHaveNone>({ block, first }, limit))
                return true;
        return false;
    }

    // Replaces the closest hit by one that is closer.
    void findCloser(const Block& block, Closest<Simd>& closest) const
    {
        for (int first = 0; hasTriangles(block, first); first += Simd::size)
            findCloserInPart({ block, first }, closest);
    }

private:
    // As many triangles of a block as a register has places: tested together, more would not fit into all registers.
    struct Part {
        const Block& block;
        int first;

        [[nodiscard]] Floats load(int axis, int corner) const
        {
            return Simd::load(&block.positions[axis][corner][first]);
        }
        [[nodiscard]] uint32_t primitive(int i) const { return block.primitives[first + i]; }
    };

    // The first part always has some.
    static bool hasTriangles(const Block& block, int first)
    {
        return first == 0 || (first < width && block.primitives[first] != Hit::none);
    }

    template <bool mostHaveNone> [[nodiscard]] bool meetsPart(const Part& part, float limit) const
    {
        const Sheared s = shear(part);
        unsigned mask = s.candidates();
        if (mostHaveNone && mask == 0)
            return false;
        const Floats t = distances(part, s);
        mask &= Simd::lessEqual(Simd::broadcast(0.0f), t) & Simd::lessEqual(t, Simd::broadcast(limit));
        if (mask == 0)
            return false;
        if ((mask & s.certain()) != 0)
            return true;
        Closest<Simd> closest(m_ray);
        findUncertain(part, m_ray, mask, closest);
        return closest.hit.primitive != Hit::none;
    }

    void findCloserInPart(const Part& part, Closest<Simd>& closest) const
    {
        const Sheared s = shear(part);
        unsigned mask = s.candidates();
        if (mask == 0)
            return;
        const Floats t = distances(part, s);
        mask &= Simd::lessEqual(Simd::broadcast(0.0f), t) & Simd::lessEqual(t, closest.limit);
        if (mask == 0)
            return;
        if (const unsigned uncertain = mask & ~s.certain(); __builtin_expect(uncertain != 0, 0)) {
            findUncertain(part, m_ray, uncertain, closest);
            mask &= ~uncertain;
        }
        alignas(64) float ts[Simd::size], us[Simd::size], vs[Simd::size];
        Simd::store(ts, t);
        s.storeWeights(us, vs);
        for (; mask != 0; mask &= mask - 1) {
            const int i = __builtin_ctz(mask);
            closest.offer({ ts[i], part.primitive(i), us[i], vs[i] });
        }
        closest.limit = Simd::broadcast(closest.hit.t);
    }

    [[nodiscard]] const float* row(const Part& part, int axis) const
    {
        const char* row = reinterpret_cast<const char*>(&part.block.positions[0][0][part.first]) + m_rows[axis];
        asm("" : "+r"(row)); // one register, and corners beside it: the compiler would keep one for each
        return reinterpret_cast<const float*>(row);
    }

    [[nodiscard]] Sheared shear(const Part& part) const
    {
        const float *const rowX = row(part, 0), *const rowY = row(part, 1), *const rowZ = row(part, 2);
        Floats corners[3][3];
        for (int corner = 0; corner < 3; ++corner) {
            corners[0][corner] = Simd::load(rowX + corner * width) - m_origin[0];
            corners[1][corner] = Simd::load(rowY + corner * width) - m_origin[1];
            corners[2][corner] = Simd::load(rowZ + corner * width) - m_origin[2];
        }
        return { corners, m_shearX, m_shearY };
    }

    [[nodiscard]] Floats distances(const Part& part, const Sheared& s) const
    {
        Floats corners[3][3];
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                corners[corner][axis] = part.load(axis, corner);
        const TrianglePlane<Simd> plane(corners[0], corners[1], corners[2], &m_ray.origin.x);
        const float* const d = &m_ray.direction.x;
        return plane.distances(Simd::broadcast(d[0]), Simd::broadcast(d[1]), Simd::broadcast(d[2]), s, m_scale);
    }

    // Triangles with a weight of zero after rounding. The ray may pass through the edge, or beside it: far from the
    // triangle, if that is seen edge-on. Were they all met, that would be wrong; were they all missed, rays would slip
    // through thin triangles, and on a coarse grid through whole groups of neighbours. Products of floats fit into a
    // double, so that here the signs are exact. Triangles without area are not met.
    [[gnu::noinline, gnu::cold]] static void findUncertain(
        const Part& part, const Ray& ray, unsigned mask, Closest<Simd>& closest)
    {
        const TriangleRay self(ray);
        const Sheared s = self.shear(part);
        alignas(64) float x[3][Simd::size], y[3][Simd::size], t[Simd::size];
        for (int corner = 0; corner < 3; ++corner) {
            Simd::store(x[corner], s.x[corner]);
            Simd::store(y[corner], s.y[corner]);
        }
        Simd::store(t, self.distances(part, s));
        for (; mask != 0; mask &= mask - 1) {
            const int i = __builtin_ctz(mask);
            const double a = weight(x[2][i], y[2][i], x[1][i], y[1][i]);
            const double b = weight(x[0][i], y[0][i], x[2][i], y[2][i]);
            const double c = weight(x[1][i], y[1][i], x[0][i], y[0][i]);
            const bool anyNegative = (a < 0.0) | (b < 0.0) | (c < 0.0);
            const bool anyPositive = (a > 0.0) | (b > 0.0) | (c > 0.0);
            if (anyNegative != anyPositive) {
                const double sum = a + b + c;
                closest.offer({ t[i], part.primitive(i), static_cast<float>(b / sum), static_cast<float>(c / sum) });
            }
        }
    }

    static double weight(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

    const Ray& m_ray;
    uint64_t m_rows[3]; // bytes to where the block has the axis that becomes x, y, z
    Floats m_origin[3], m_shearX, m_shearY, m_scale;
};

}
