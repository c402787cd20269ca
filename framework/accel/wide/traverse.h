#pragma once
#include "accel/wide/box_ray.h"
#include "accel/wide/kernels.h"
#include "accel/wide/triangle_ray.h"
#include "accel/wide/visits.h"

namespace accel::wide {

struct NotCounted {
    static void node() { }
    static void block() { }
};

struct Counted {
    void node() const { ++counters.nodes; }
    void block() const { ++counters.blocks; }
    Counters& counters;
};

// The traversal for one instruction set. Everything here is a member of a template of it: were a function shared, the
// linker could pick the copy that the processor cannot run. For the same reason there is nothing of the standard
// library.
template <typename Simd> class Traversal {
    using Floats = typename Simd::Floats;
    using Visits = wide::Visits<Simd>;
    using Visit = typename Visits::Visit;
    using Register = typename Simd::Register; // triangles are tested a register at a time: more spill

public:
    static bool closest(const View& tree, const Ray& ray, Hit& hit)
    {
        return findClosest(tree, ray, hit, NotCounted {});
    }

    static bool closestCounted(const View& tree, const Ray& ray, Hit& hit, Counters& counters)
    {
        return findClosest(tree, ray, hit, Counted { counters });
    }

    template <typename Count>
    [[gnu::always_inline]] static bool findClosest(const View& tree, const Ray& ray, Hit& hit, Count count)
    {
        Closest<Register> closest(ray);
        if (tree.numNodes == 0) {
            const TriangleRay<Register> triangleRay(ray);
            for (uint32_t i = 0; i < tree.numBlocks; ++i) {
                count.block();
                triangleRay.findCloser(tree.blocks[i], closest);
            }
        } else {
            const BoxRay<Simd> boxRay(tree, ray); // first: the root waits for it
            descend(tree, 0, boxRay, TriangleRay<Register>(ray), closest, count);
        }
        if (closest.hit.primitive == Hit::none)
            return false;
        hit = closest.hit;
        return true;
    }

    template <typename Count>
    [[gnu::always_inline]] static void descend(const View& tree, Child current, const BoxRay<Simd>& boxRay,
        const TriangleRay<Register>& triangleRay, Closest<Register>& closest, Count count)
    {
        Visit stack[maxDepth * (width - 1)];
        Visit* top = stack;
        for (;;) {
            count.node();
            const Child* const children = Visits::nodeAt(tree, current).children;
            Floats entry;
            unsigned mask = boxRay.meets(current, Simd::broadcast(closest.hit.t), entry);
            const unsigned isBlock = Simd::topBits(children);
            if (unsigned blocks = mask & isBlock; blocks != 0) {
                do {
                    count.block();
                    triangleRay.findCloser(Visits::blockAt(tree, children[__builtin_ctz(blocks)]), closest);
                } while ((blocks &= blocks - 1) != 0);
                mask &= ~isBlock & Simd::lessEqual(entry, Simd::broadcast(closest.hit.t));
            }
            if (mask != 0) {
                current = Visits::nearestOf(tree, children, mask, entry, top);
                continue;
            }
            const uint32_t limit = Visits::bitsOf(closest.hit.t);
            do {
                if (top == stack)
                    return;
                current = Visits::childOf(*--top);
            } while (*top >> 32 > limit);
        }
    }

    static bool occluded(const View& tree, const Ray& ray) { return findAny(tree, ray, NotCounted {}); }

    static bool occludedCounted(const View& tree, const Ray& ray, Counters& counters)
    {
        return findAny(tree, ray, Counted { counters });
    }

    template <typename Count> [[gnu::always_inline]] static bool findAny(const View& tree, const Ray& ray, Count count)
    {
        if (tree.numNodes == 0) {
            const TriangleRay<Register> triangleRay(ray);
            for (uint32_t i = 0; i < tree.numBlocks; ++i) {
                count.block();
                if (triangleRay.template meets<true>(tree.blocks[i], ray.t))
                    return true;
            }
            return false;
        }
        const Floats limit = Simd::broadcast(ray.t);
        const BoxRay<Simd> boxRay(tree, ray);
        const TriangleRay<Register> triangleRay(ray);
        Child stack[maxDepth * (width - 1) + width];
        Child* top = stack;
        Child current = 0;
        for (;;) {
            count.node();
            const Child* const children = Visits::nodeAt(tree, current).children;
            Floats entry;
            unsigned mask = boxRay.meets(current, limit, entry);
            const unsigned isBlock = Simd::topBits(children);
            for (unsigned blocks = mask & isBlock; blocks != 0; blocks &= blocks - 1) {
                count.block();
                if (triangleRay.template meets<false>(Visits::blockAt(tree, children[__builtin_ctz(blocks)]), ray.t))
                    return true;
            }
            mask &= ~isBlock;
            if (mask != 0) {
                current = children[__builtin_ctz(mask)];
                for (mask &= mask - 1; mask != 0; mask &= mask - 1)
                    *top++ = children[__builtin_ctz(mask)];
                continue;
            }
            if (top == stack)
                return false;
            current = *--top;
        }
    }
};

}
