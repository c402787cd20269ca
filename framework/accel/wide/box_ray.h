#pragma once
#include "accel/wide/margin.h"
#include "accel/wide/node.h"
#include <framework/ray.h>

namespace accel::wide {

// Where a ray passes planes across each axis: at a plane's place * inverse - offset. The margin of the boxes is in the
// offsets. What follows another ray waits for all of this: few steps after one another count, not few in all.
template <typename Simd> struct Slabs {
    using Floats = typename Simd::Floats;
    // Three coordinates, and a fourth that nobody looks at.
    using Float4 = float __attribute__((vector_size(16)));

    Slabs(const View& tree, const Ray& ray)
    {
        const Float4 origin = load(&ray.origin.x), direction = load(&ray.direction.x);
        const float margin = marginOf(tree, origin);
        const Float4 towards = withSign(Float4 { margin, margin, margin, margin }, direction);
        nearOrigin = origin + towards;
        farOrigin = origin - towards;

        // Never zero, so that no distance is infinity minus infinity: so small a slope stays within the margin.
        const Float4 size = magnitude(direction), least = Float4 {} + leastSlope;
        inverse = 1.0f / withSign(size > least ? size : least, direction);
        negative = Simd::signs(direction) & 7;
    }

    [[nodiscard]] Float4 nearOffset() const { return nearOrigin * inverse; }
    [[nodiscard]] Float4 farOffset() const { return farOrigin * inverse; }

    // Which row of a node's bounds is the nearer one; the farther one is its neighbour, ^ 1.
    [[nodiscard]] unsigned nearRow(unsigned axis) const { return 2 * axis + ((negative >> axis) & 1); }

    // Which boxes are met within the limit whose planes are passed there, inwards and outwards; entry becomes where.
    // Kay and Kajiya 1986.
    [[nodiscard]] static unsigned meets(const Floats (&in)[3], const Floats (&out)[3], Floats limit, Floats& entry)
    {
        entry = Simd::max(Simd::max(in[0], in[1]), Simd::max(in[2], Simd::broadcast(0.0f)));
        const Floats exit = Simd::min(Simd::min(out[0], out[1]), Simd::min(out[2], limit));
        return Simd::lessEqual(entry, exit);
    }

    // By how much boxes count as larger. To the farthest corner, and to zero, the origin has at most the way to the
    // tree's middle and the way from there, which is the same for all rays.
    static float marginOf(const View& tree, Float4 origin)
    {
        return largest(magnitude(origin - load(tree.middle))) * (marginOfReach + marginOfOrigin) + tree.margin;
    }

    static Float4 load(const float* p)
    {
        Float4 a;
        __builtin_memcpy(&a, p, sizeof a);
        return a;
    }

    Float4 inverse, nearOrigin, farOrigin;
    unsigned negative; // a bit for each axis

private:
    using Int4 = int __attribute__((vector_size(16)));

    static constexpr float leastSlope = 0x1p-80f;

    static float max(float a, float b) { return a > b ? a : b; }
    static float largest(Float4 a) { return max(max(a[0], a[1]), a[2]); }
    // Of the fourth, which may be anything: zero. Numbers too small to be normal take long.
    static Float4 magnitude(Float4 a)
    {
        return reinterpret_cast<Float4>(reinterpret_cast<Int4>(a) & Int4 { 0x7fffffff, 0x7fffffff, 0x7fffffff, 0 });
    }

    static Float4 withSign(Float4 a, Float4 b)
    {
        return reinterpret_cast<Float4>(reinterpret_cast<Int4>(a) | (reinterpret_cast<Int4>(b) & ~0x7fffffff));
    }
};

// A ray as the box test wants it.
template <typename Simd> class BoxRay {
    using Floats = typename Simd::Floats;
    using Slabs = wide::Slabs<Simd>;

public:
    BoxRay(const View& tree, const Ray& ray)
    {
        const Slabs slabs(tree, ray);
        const auto nearOffset = slabs.nearOffset(), farOffset = slabs.farOffset();
        for (unsigned i = 0; i < 3; ++i) {
            m_inverse[i] = Simd::broadcast(slabs.inverse[i]);
            m_nearOffset[i] = Simd::broadcast(nearOffset[i]);
            m_farOffset[i] = Simd::broadcast(farOffset[i]);
            m_nearRows[i] = reinterpret_cast<const char*>(tree.nodes) + slabs.nearRow(i) * rowSize;
            m_farRows[i] = reinterpret_cast<const char*>(tree.nodes) + (slabs.nearRow(i) ^ 1) * rowSize;
        }
    }

    // Which of the node's boxes the ray meets within the limit; entry becomes where.
    [[nodiscard]] unsigned meets(Child node, Floats limit, Floats& entry) const
    {
        Floats in[3], out[3];
        for (int i = 0; i < 3; ++i) {
            in[i] = Simd::multiplySubtract(row(m_nearRows[i], node), m_inverse[i], m_nearOffset[i]);
            out[i] = Simd::multiplySubtract(row(m_farRows[i], node), m_inverse[i], m_farOffset[i]);
        }
        return Slabs::meets(in, out, limit, entry);
    }

private:
    static constexpr uint64_t rowSize = width * sizeof(float);

    static Floats row(const char* rows, Child node)
    {
        return Simd::load(reinterpret_cast<const float*>(rows + node * childUnit));
    }

    const char *m_nearRows[3], *m_farRows[3]; // of the first node
    Floats m_inverse[3], m_nearOffset[3], m_farOffset[3];
};

}
