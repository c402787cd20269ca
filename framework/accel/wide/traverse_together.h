#pragma once
#include "accel/wide/beam.h"
#include "accel/wide/traverse.h"
#include "accel/wide/triangle_beam.h"

namespace accel::wide {

// The traversal of up to mostRays, together as far as they have the same way: few nodes are visited for all of them.
// Each finds what it finds alone. As Traversal, all is in a template of the instruction set.
template <typename Simd> class TogetherTraversal {
    using Floats = typename Simd::Floats;
    using Visits = wide::Visits<Simd>;
    using Visit = typename Visits::Visit;
    using Register = typename Simd::Register;
    using Rays = typename Beam<Simd>::Rays;

public:
    static void closestOfEach(const View& tree, const Ray* rays, unsigned count, Hit* hits)
    {
        if (count >= few && areFromOnePoint(rays, count)) {
            TogetherTraversal all(tree, rays, count, hits);
            if (tree.numNodes == 0)
                all.testBlocks();
            else
                all.descend();
            return;
        }
        for (unsigned i = 0; i < count; ++i) {
            hits[i] = Closest<Register>::noneYet(rays[i]);
            (void)Traversal<Simd>::closest(tree, rays[i], hits[i]);
        }
    }

private:
    static constexpr unsigned few = 3; // rays fewer than these are faster alone

    static bool areFromOnePoint(const Ray* rays, unsigned count)
    {
        bool are = true;
        for (unsigned i = 1; i < count; ++i)
            are &= rays[i].origin.x == rays[0].origin.x && rays[i].origin.y == rays[0].origin.y
                && rays[i].origin.z == rays[0].origin.z;
        return are;
    }

    static Rays allOf(unsigned count) { return ~Rays { 0 } >> (mostRays - count); }

    TogetherTraversal(const View& tree, const Ray* rays, unsigned count, Hit* hits)
        : m_tree(tree)
        , m_rays(rays)
        , m_count(count)
        , m_hits(hits)
        , m_triangleBeam(rays, count)
    {
        for (unsigned i = 0; i < count; ++i) {
            hits[i] = Closest<Register>::noneYet(rays[i]);
            m_limits[i] = rays[i].t;
        }
        for (unsigned i = count; i % width != 0; ++i)
            m_limits[i] = -1.0f; // meets nothing
    }

    void testBlocks()
    {
        for (uint32_t i = 0; i < m_tree.numBlocks; ++i)
            test(m_tree.blocks[i], allOf(m_count));
    }

    void descend()
    {
        const Beam<Simd> beam(m_tree, m_rays, m_count);
        if (beam.isOne())
            descend(beam);
        else
            descendAlone(allOf(m_count), 0);
    }

    void descend(const Beam<Simd>& beam)
    {
        Visit stack[maxDepth * (width - 1)];
        Visit* top = stack;
        Child current = 0;
        float limit = farthestLimit();
        for (;;) {
            const Node& node = Visits::nodeAt(m_tree, current);
            Floats entry;
            unsigned mask = beam.mayMeet(node, limit, entry);
            const unsigned isBlock = Simd::topBits(node.children);
            if (unsigned blocks = mask & isBlock; blocks != 0) {
                for (; blocks != 0; blocks &= blocks - 1) {
                    const int i = __builtin_ctz(blocks);
                    test(Visits::blockAt(m_tree, node.children[i]), beam.thatMeet(node, i, m_limits));
                }
                limit = farthestLimit();
                mask &= ~isBlock & Simd::lessEqual(entry, Simd::broadcast(limit));
            }
            mask = withoutThoseOfFew(beam, node, mask);
            if (mask != 0) {
                current = Visits::nearestOf(m_tree, node.children, mask, entry, top);
                continue;
            }
            const uint32_t limitBits = Visits::bitsOf(limit);
            do {
                if (top == stack)
                    return;
                current = Visits::childOf(*--top);
            } while (*top >> 32 > limitBits);
        }
    }

    // Children that few rays meet are visited by each of these alone, at once; the others are left.
    unsigned withoutThoseOfFew(const Beam<Simd>& beam, const Node& node, unsigned children)
    {
        for (unsigned rest = children; rest != 0; rest &= rest - 1) {
            const int i = __builtin_ctz(rest);
            const Rays rays = beam.thatMeet(node, i, m_limits);
            if (static_cast<unsigned>(__builtin_popcountll(rays)) >= few)
                continue;
            children &= ~(1u << i);
            descendAlone(rays, node.children[i]);
        }
        return children;
    }

    void descendAlone(Rays rays, Child node)
    {
        for (; rays != 0; rays &= rays - 1) {
            const int i = __builtin_ctzll(rays);
            const BoxRay<Simd> boxRay(m_tree, m_rays[i]);
            const TriangleRay<Register> triangleRay(m_rays[i]);
            Closest<Register> closest(m_hits[i]);
            Traversal<Simd>::descend(m_tree, node, boxRay, triangleRay, closest, NotCounted {});
            replace(i, closest.hit);
        }
    }

    // Triangle by triangle, each for many rays, or ray by ray, each for many triangles.
    void test(const Block& block, Rays rays)
    {
        const auto numRays = static_cast<unsigned>(__builtin_popcountll(rays));
        if (numRays < few || !m_triangleBeam.isOne()) {
            testAlone(block, rays);
            return;
        }
        unsigned triangles = m_triangleBeam.mayMeet(block);
        const auto numTriangles = static_cast<unsigned>(__builtin_popcount(triangles));
        if (numTriangles > numRays) {
            testAlone(block, rays);
            return;
        }
        for (; triangles != 0; triangles &= triangles - 1)
            m_triangleBeam.findCloser(block, __builtin_ctz(triangles), rays, m_hits, m_limits);
    }

    void testAlone(const Block& block, Rays rays)
    {
        for (; rays != 0; rays &= rays - 1) {
            const int i = __builtin_ctzll(rays);
            Closest<Register> closest(m_hits[i]);
            TriangleRay<Register>(m_rays[i]).findCloser(block, closest);
            replace(i, closest.hit);
        }
    }

    void replace(int ray, const Hit& hit)
    {
        m_hits[ray] = hit;
        m_limits[ray] = hit.t;
    }

    [[nodiscard]] float farthestLimit() const
    {
        float farthest = 0.0f;
        for (unsigned i = 0; i < m_count; ++i)
            farthest = m_limits[i] > farthest ? m_limits[i] : farthest;
        return farthest;
    }

    const View& m_tree;
    const Ray* m_rays;
    unsigned m_count;
    Hit* m_hits; // so far
    alignas(64) float m_limits[mostRays]; // their distances
    TriangleBeam<Register> m_triangleBeam;
};

}
