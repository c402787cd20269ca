#pragma once
#include "accel/wide/box_ray.h"

namespace accel::wide {

// Rays from one point, into one octant, as the box test wants them: all at once, for boxes that none of them meets, and
// each beside the others. What a ray meets alone it also meets here. Boulos, Wald, Shirley 2006, "Geometric and
// Arithmetic Culling Methods for Entire Ray Packets", section 2.2.
template <typename Simd> class Beam {
    using Floats = typename Simd::Floats;
    using Slabs = wide::Slabs<Simd>;

public:
    using Rays = uint64_t; // a bit for each

    Beam(const View& tree, const Ray* rays, unsigned count)
        : m_count(count)
    {
        const Slabs first(tree, rays[0]);
        Slabs flattest = first, steepest = first;
        for (unsigned i = 0; i < count; ++i) {
            const Slabs slabs(tree, rays[i]);
            m_isOne &= slabs.negative == first.negative;
            flattest.inverse = slabs.inverse < flattest.inverse ? slabs.inverse : flattest.inverse;
            steepest.inverse = slabs.inverse > steepest.inverse ? slabs.inverse : steepest.inverse;
            set(i, slabs);
        }
        for (unsigned i = count; i % width != 0; ++i)
            set(i, first); // nobody looks at these
        m_extremes[0] = Extreme(flattest);
        m_extremes[1] = Extreme(steepest);
        for (unsigned axis = 0; axis < 3; ++axis) {
            m_nearRows[axis] = first.nearRow(axis);
            m_farRows[axis] = m_nearRows[axis] ^ 1;
        }
    }

    // Whether they lead into one octant, as they must.
    [[nodiscard]] bool isOne() const { return m_isOne; }

    // Which of the node's boxes a ray may meet within the limit: all that one does, perhaps others. No ray enters them
    // before entry. Whatever its slope, it passes a plane between where the flattest and the steepest do.
    [[nodiscard]] unsigned mayMeet(const Node& node, float limit, Floats& entry) const
    {
        const auto& [a, b] = m_extremes;
        Floats in[3], out[3];
        for (int i = 0; i < 3; ++i) {
            const Floats nearPlane = Simd::load(rowOf(node, m_nearRows[i])),
                         farPlane = Simd::load(rowOf(node, m_farRows[i]));
            in[i] = Simd::min(Simd::multiplySubtract(nearPlane, a.inverse[i], a.nearOffset[i]),
                Simd::multiplySubtract(nearPlane, b.inverse[i], b.nearOffset[i]));
            out[i] = Simd::max(Simd::multiplySubtract(farPlane, a.inverse[i], a.farOffset[i]),
                Simd::multiplySubtract(farPlane, b.inverse[i], b.farOffset[i]));
        }
        return Slabs::meets(in, out, Simd::broadcast(limit), entry);
    }

    // Which rays meet one of the node's boxes within their own limits.
    [[nodiscard]] Rays thatMeet(const Node& node, int child, const float* limits) const
    {
        Floats nearPlanes[3], farPlanes[3];
        for (int i = 0; i < 3; ++i) {
            nearPlanes[i] = Simd::broadcast(rowOf(node, m_nearRows[i])[child]);
            farPlanes[i] = Simd::broadcast(rowOf(node, m_farRows[i])[child]);
        }
        Rays rays = 0;
        for (unsigned first = 0; first < m_count; first += width) {
            Floats in[3], out[3], entry;
            for (int i = 0; i < 3; ++i) {
                const Floats inverse = Simd::load(m_inverse[i] + first);
                in[i] = Simd::multiplySubtract(nearPlanes[i], inverse, Simd::load(m_nearOffset[i] + first));
                out[i] = Simd::multiplySubtract(farPlanes[i], inverse, Simd::load(m_farOffset[i] + first));
            }
            rays |= Rays { Slabs::meets(in, out, Simd::load(limits + first), entry) } << first;
        }
        return rays;
    }

private:
    struct Extreme {
        Extreme() = default;
        explicit Extreme(const Slabs& slabs)
        {
            const auto nears = slabs.nearOffset(), fars = slabs.farOffset();
            for (int i = 0; i < 3; ++i) {
                inverse[i] = Simd::broadcast(slabs.inverse[i]);
                nearOffset[i] = Simd::broadcast(nears[i]);
                farOffset[i] = Simd::broadcast(fars[i]);
            }
        }

        Floats inverse[3], nearOffset[3], farOffset[3];
    };

    void set(unsigned ray, const Slabs& slabs)
    {
        const auto nears = slabs.nearOffset(), fars = slabs.farOffset();
        for (int i = 0; i < 3; ++i) {
            m_inverse[i][ray] = slabs.inverse[i];
            m_nearOffset[i][ray] = nears[i];
            m_farOffset[i][ray] = fars[i];
        }
    }

    static const float* rowOf(const Node& node, unsigned row) { return node.bounds[row / 2][row % 2]; }

    unsigned m_count;
    bool m_isOne = true;
    unsigned m_nearRows[3], m_farRows[3]; // of a node's bounds
    Extreme m_extremes[2];
    alignas(64) float m_inverse[3][mostRays], m_nearOffset[3][mostRays], m_farOffset[3][mostRays]; // of each ray
};

}
