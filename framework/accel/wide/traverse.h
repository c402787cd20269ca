#pragma once
#include "accel/wide/box_ray.h"
#include "accel/wide/kernels.h"
#include "accel/wide/triangle_ray.h"

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
    using Register = typename Simd::Register; // triangles are tested a register at a time: more spill

public:
    static constexpr Kernel kernel(const char* name)
    {
        return { name, closest, closestCounted, occluded, occludedCounted };
    }

private:
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
            descend(tree, boxRay, TriangleRay<Register>(ray), closest, count);
        }
        if (closest.hit.primitive == closest.none)
            return false;
        hit = closest.hit;
        return true;
    }

    // A child that waits: its distance above, so that the nearer of two is the smaller.
    using Visit = uint64_t;
    static Visit visit(Child child, uint32_t distance) { return uint64_t { distance } << 32 | child; }
    static Child childOf(Visit visit) { return static_cast<Child>(visit); }

    static uint32_t bitsOf(float distance)
    {
        uint32_t bits;
        __builtin_memcpy(&bits, &distance, sizeof bits);
        return bits;
    }

    static const Child* childrenOf(const View& tree, Child node)
    {
        return reinterpret_cast<const Node*>(reinterpret_cast<const char*>(tree.nodes) + node * childUnit)->children;
    }

    // A node that waits is fetched meanwhile.
    static void prefetch(const View& tree, Child node)
    {
        const char* const lines = reinterpret_cast<const char*>(tree.nodes) + node * childUnit;
        for (unsigned i = 0; i < sizeof(Node); i += 64)
            __builtin_prefetch(lines + i);
    }

    static const Block& blockOf(const View& tree, Child block)
    {
        const char* const blocks = reinterpret_cast<const char*>(tree.blocks);
        return *reinterpret_cast<const Block*>(blocks + (block & ~blockBit) * childUnit);
    }

    static void order(Visit& a, Visit& b)
    {
        if (b < a) {
            const Visit c = a;
            a = b;
            b = c;
        }
    }

    // Puts the others aside, the nearest on top. One, two or three are told apart by jumps: these are foreseen more
    // often than not, and then nobody waits for the comparison.
    [[gnu::always_inline]] static Child nearestOf(
        const View& tree, const Child* children, unsigned mask, Floats entry, Visit*& top)
    {
        const int first = __builtin_ctz(mask);
        unsigned rest = mask & (mask - 1);
        if (rest == 0)
            return children[first];

        alignas(64) float entries[width];
        Simd::store(entries, entry);
        const int second = __builtin_ctz(rest);
        rest &= rest - 1;
        if (rest == 0) {
            const bool inOrder = entries[first] <= entries[second];
            if (inOrder) {
                postpone(tree, visit(children[second], bitsOf(entries[second])), top);
                return children[first];
            }
            postpone(tree, visit(children[first], bitsOf(entries[first])), top);
            return children[second];
        }

        const int third = __builtin_ctz(rest);
        rest &= rest - 1;
        if (rest == 0) {
            Visit a = visit(children[first], bitsOf(entries[first]));
            Visit b = visit(children[second], bitsOf(entries[second]));
            Visit c = visit(children[third], bitsOf(entries[third]));
            order(a, b);
            order(b, c);
            order(a, b);
            postpone(tree, c, top);
            postpone(tree, b, top);
            return childOf(a);
        }
        top = pushSorted(mask, children, entries, top);
        return childOf(*--top);
    }

    static void postpone(const View& tree, Visit visit, Visit*& top)
    {
        *top++ = visit;
        prefetch(tree, childOf(visit));
    }

    // The nearest last, on top. Rare, and apart so that the loop keeps its registers.
    [[gnu::noinline]] static Visit* pushSorted(unsigned mask, const Child* children, const float* entries, Visit* top)
    {
        const Visit* const bottom = top;
        for (; mask != 0; mask &= mask - 1) {
            const int i = __builtin_ctz(mask);
            const Visit next = visit(children[i], bitsOf(entries[i]));
            Visit* place = top++;
            for (; place != bottom && place[-1] < next; --place)
                *place = place[-1];
            *place = next;
        }
        return top;
    }

    template <typename Count>
    [[gnu::always_inline]] static void descend(const View& tree, const BoxRay<Simd>& boxRay,
        const TriangleRay<Register>& triangleRay, Closest<Register>& closest, Count count)
    {
        Visit stack[maxDepth * (width - 1)];
        Visit* top = stack;
        Child current = 0;
        for (;;) {
            count.node();
            const Child* const children = childrenOf(tree, current);
            Floats entry;
            unsigned mask = boxRay.meets(current, Simd::broadcast(closest.hit.t), entry);
            const unsigned isBlock = Simd::topBits(children);
            if (unsigned blocks = mask & isBlock; blocks != 0) {
                do {
                    count.block();
                    triangleRay.findCloser(blockOf(tree, children[__builtin_ctz(blocks)]), closest);
                } while ((blocks &= blocks - 1) != 0);
                mask &= ~isBlock & Simd::lessEqual(entry, Simd::broadcast(closest.hit.t));
            }
            if (mask != 0) {
                current = nearestOf(tree, children, mask, entry, top);
                continue;
            }
            const uint32_t limit = bitsOf(closest.hit.t);
            do {
                if (top == stack)
                    return;
                current = childOf(*--top);
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
            const Child* const children = childrenOf(tree, current);
            Floats entry;
            unsigned mask = boxRay.meets(current, limit, entry);
            const unsigned isBlock = Simd::topBits(children);
            for (unsigned blocks = mask & isBlock; blocks != 0; blocks &= blocks - 1) {
                count.block();
                if (triangleRay.template meets<false>(blockOf(tree, children[__builtin_ctz(blocks)]), ray.t))
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
