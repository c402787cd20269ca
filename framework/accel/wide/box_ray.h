#pragma once
#include "accel/wide/node.h"
#include <framework/ray.h>

namespace accel::wide {

// A ray as the box test wants it, with all that may be lost to rounding given to the boxes.
template <typename Simd> class BoxRay {
    using Floats = typename Simd::Floats;

public:
    BoxRay(const View& tree, const Ray& ray)
    {
        const float origin[3] = { ray.origin.x, ray.origin.y, ray.origin.z };
        const float direction[3] = { ray.direction.x, ray.direction.y, ray.direction.z };
        float reach = 0.0f; // to the farthest corner of all, along an axis
        for (int i = 0; i < 3; ++i)
            reach = max(reach, max(origin[i] - tree.lower[i], tree.upper[i] - origin[i]));
        for (int i = 0; i < 3; ++i) {
            const float margin = reach * triangleRounding + __builtin_fabsf(origin[i]) * epsilon;
            const float towards = __builtin_copysignf(margin, direction[i]);
            const float inverse = 1.0f / direction[i];
            const unsigned isNegative = __builtin_signbitf(direction[i]) != 0;
            m_nearRow[i] = (2 * static_cast<unsigned>(i) + isNegative) * width;
            m_farRow[i] = (2 * static_cast<unsigned>(i) + 1 - isNegative) * width;
            m_nearOrigin[i] = Simd::broadcast(origin[i] + towards);
            m_farOrigin[i] = Simd::broadcast(origin[i] - towards);
            m_nearInverse[i] = Simd::broadcast(inverse);
            m_farInverse[i] = Simd::broadcast(inverse * slabRounding);
        }
    }

    // Which of the node's boxes the ray meets within the limit; entry becomes where. Kay and Kajiya 1986. An origin on
    // a face and a direction along it give NaN, which loses as a first operand; as a second one, it lets go of one
    // axis: a box then may be met that is not, never the other way round.
    [[nodiscard]] unsigned meets(const Node& node, Floats limit, Floats& entry) const
    {
        const float* const rows = &node.bounds[0][0][0];
        Floats in[3], out[3];
        for (int i = 0; i < 3; ++i) {
            in[i] = (Simd::load(rows + m_nearRow[i]) - m_nearOrigin[i]) * m_nearInverse[i];
            out[i] = (Simd::load(rows + m_farRow[i]) - m_farOrigin[i]) * m_farInverse[i];
        }
        entry = Simd::max(Simd::max(in[0], in[1]), Simd::max(in[2], Simd::broadcast(0.0f)));
        const Floats exit = Simd::min(Simd::min(out[0], out[1]), Simd::min(out[2], limit));
        return Simd::lessEqual(entry, exit);
    }

private:
    static constexpr float epsilon = 0x1p-23f;
    // The rounding of a slab's distances, Ize 2013, "Robust BVH Ray Traversal", and of this factor itself.
    static constexpr float slabRounding = 1.0f + 4.0f * epsilon;
    // How far the triangle test may move a corner: five roundings of what it is away along two axes. A ray that it
    // finds on a triangle passes through its box if that is so much larger. Woop, Benthin, Wald 2013, section 4.
    static constexpr float triangleRounding = 2.0f * 5.0f * epsilon / 2.0f * 1.2f; // and second order

    static float max(float a, float b) { return a > b ? a : b; }

    unsigned m_nearRow[3], m_farRow[3];
    Floats m_nearOrigin[3], m_farOrigin[3], m_nearInverse[3], m_farInverse[3];
};

}
