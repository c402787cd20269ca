#pragma once
#include "accel/wide/node.h"
#include <framework/ray.h>

namespace accel::wide {

// What a ray knows of the closest hit so far; of one still to be found: the end of the ray, no primitive.
template <typename Simd> struct Closest {
    explicit Closest(const Ray& ray)
        : limit(Simd::broadcast(ray.t))
        , hit { ray.t, none, 0.0f, 0.0f }
    {
    }

    void offer(const Hit& other)
    {
        if (other.t < hit.t || (other.t == hit.t && other.primitive < hit.primitive))
            hit = other;
    }

    static constexpr uint32_t none = ~uint32_t { 0 };
    typename Simd::Floats limit; // hit.t
    Hit hit;
};

// A ray as the triangle test wants it: turned and sheared so that it is the z axis. Woop, Benthin, Wald 2013,
// "Watertight Ray/Triangle Intersection".
template <typename Simd> class TriangleRay {
    using Floats = typename Simd::Floats;

public:
    explicit TriangleRay(const Ray& ray)
        : m_ray(ray)
    {
        const float d[3] = { ray.direction.x, ray.direction.y, ray.direction.z };
        const float origin[3] = { ray.origin.x, ray.origin.y, ray.origin.z };
        const float x = __builtin_fabsf(d[0]), y = __builtin_fabsf(d[1]), z = __builtin_fabsf(d[2]);
        const unsigned zLargest = (z > x) & (z > y), yLargest = (y > x) & ~zLargest & 1; // no jumps
        const unsigned axisZ = 2 * zLargest | yLargest;
        const unsigned axisX = (9 >> 2 * axisZ) & 3, axisY = (18 >> 2 * axisZ) & 3; // the next two: 1 2 0, 2 0 1
        const unsigned axes[3] = { axisX, axisY, axisZ };
        for (int i = 0; i < 3; ++i) {
            m_rows[i] = axes[i] * sizeof(Block::positions[0]);
            m_origin[i] = Simd::broadcast(origin[axes[i]]);
        }
        const float scale = 1.0f / d[axisZ];
        m_shearX = Simd::broadcast(d[axisX] * scale);
        m_shearY = Simd::broadcast(d[axisY] * scale);
        m_scale = Simd::broadcast(scale);
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
        return first == 0 || (first < width && block.primitives[first] != Closest<Simd>::none);
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
        const unsigned certain = mask & s.withArea();
        if (certain != 0)
            return true;
        Closest<Simd> closest(m_ray);
        findEdgeOn(part, m_ray, mask, closest);
        return closest.hit.primitive != closest.none;
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
        if (const unsigned edgeOn = mask & ~s.withArea(); __builtin_expect(edgeOn != 0, 0)) {
            findEdgeOn(part, m_ray, edgeOn, closest);
            mask &= ~edgeOn;
        }
        alignas(64) float ts[Simd::size], us[Simd::size], vs[Simd::size];
        const Floats sum = s.weights[0] + s.weights[1] + s.weights[2];
        Simd::store(ts, t);
        Simd::store(us, s.weights[1] / sum);
        Simd::store(vs, s.weights[2] / sum);
        for (; mask != 0; mask &= mask - 1) {
            const int i = __builtin_ctz(mask);
            closest.offer({ ts[i], part.primitive(i), us[i], vs[i] });
        }
        closest.limit = Simd::broadcast(closest.hit.t);
    }

    // The corners seen along the ray. An edge function is negative, positive or zero for all triangles that share the
    // edge, but for its sign, if the products are rounded before they are subtracted: no fused multiply-add here.
    struct Sheared {
        Floats x[3], y[3], z[3]; // of the corners
        Floats weights[3]; // of the corners, unnormalised
        Floats least, most; // of the weights

        [[nodiscard]] unsigned candidates() const
        {
            const Floats zero = Simd::broadcast(0.0f);
            return Simd::lessEqual(zero, least) | Simd::lessEqual(most, zero);
        }

        // Not those that are seen edge-on.
        [[nodiscard]] unsigned withArea() const { return Simd::less(least, most); }
    };

    [[nodiscard]] const float* row(const Part& part, int axis) const
    {
        const char* row = reinterpret_cast<const char*>(&part.block.positions[0][0][part.first]) + m_rows[axis];
        asm("" : "+r"(row)); // one register, and corners beside it: the compiler would keep one for each
        return reinterpret_cast<const float*>(row);
    }

    [[nodiscard]] Sheared shear(const Part& part) const
    {
        Sheared s;
        const float *const rowX = row(part, 0), *const rowY = row(part, 1), *const rowZ = row(part, 2);
        for (int corner = 0; corner < 3; ++corner) {
            s.z[corner] = Simd::load(rowZ + corner * width) - m_origin[2];
            s.x[corner] = Simd::load(rowX + corner * width) - m_origin[0] - m_shearX * s.z[corner];
            s.y[corner] = Simd::load(rowY + corner * width) - m_origin[1] - m_shearY * s.z[corner];
        }
        s.weights[0] = s.x[2] * s.y[1] - s.y[2] * s.x[1];
        s.weights[1] = s.x[0] * s.y[2] - s.y[0] * s.x[2];
        s.weights[2] = s.x[1] * s.y[0] - s.y[1] * s.x[0];
        s.least = Simd::min(Simd::min(s.weights[0], s.weights[1]), s.weights[2]);
        s.most = Simd::max(Simd::max(s.weights[0], s.weights[1]), s.weights[2]);
        return s;
    }

    // From the plane's equation, since a weighted sum of the corners loses digits on huge triangles; in the order of
    // intersectRayWithTriangle, for the same bits. Within what the corners allow but for rounding: seen edge-on, the
    // equation loses all digits. Not a number gives way to that, as a first operand.
    [[nodiscard]] Floats distances(const Part& part, const Sheared& s) const
    {
        const float* const origin = &m_ray.origin.x;
        const float* const direction = &m_ray.direction.x;
        Floats corner[3], edge1[3], edge2[3];
        for (int axis = 0; axis < 3; ++axis) {
            const Floats first = part.load(axis, 0);
            corner[axis] = first - Simd::broadcast(origin[axis]);
            edge1[axis] = part.load(axis, 1) - first;
            edge2[axis] = part.load(axis, 2) - first;
        }
        const Floats normalX = edge1[1] * edge2[2] - edge1[2] * edge2[1];
        const Floats normalY = edge1[2] * edge2[0] - edge1[0] * edge2[2];
        const Floats normalZ = edge1[0] * edge2[1] - edge1[1] * edge2[0];
        const Floats height = normalX * corner[0] + normalY * corner[1] + normalZ * corner[2];
        const Floats slope = normalX * Simd::broadcast(direction[0]) + normalY * Simd::broadcast(direction[1])
            + normalZ * Simd::broadcast(direction[2]);

        const Floats first = s.z[0] * m_scale, second = s.z[1] * m_scale, third = s.z[2] * m_scale;
        const Floats nearest = Simd::min(Simd::min(first, second), third) * Simd::broadcast(1.0f - 0x1p-21f);
        const Floats farthest = Simd::max(Simd::max(first, second), third) * Simd::broadcast(1.0f + 0x1p-21f);
        return Simd::min(Simd::max(height / slope, nearest), farthest);
    }

    // Triangles whose weights are all zero after rounding. Without area they are not met, but that of a thin one may be
    // too small to see, and on a coarse grid whole groups of neighbours are seen edge-on: without them the ray would
    // slip through. Products of floats fit into a double, so that here the signs are exact.
    [[gnu::noinline, gnu::cold]] static void findEdgeOn(
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
