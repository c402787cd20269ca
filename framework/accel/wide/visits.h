#pragma once
#include "accel/wide/node.h"

namespace accel::wide {

// Nodes and blocks where a node says that they are, and those of a node's children that wait while the nearest is
// visited.
template <typename Simd> class Visits {
    using Floats = typename Simd::Floats;

public:
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

    static const Node& nodeAt(const View& tree, Child node)
    {
        return *reinterpret_cast<const Node*>(reinterpret_cast<const char*>(tree.nodes) + node * childUnit);
    }

    static const Block& blockAt(const View& tree, Child block)
    {
        const char* const blocks = reinterpret_cast<const char*>(tree.blocks);
        return *reinterpret_cast<const Block*>(blocks + (block & ~blockBit) * childUnit);
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

private:
    static void order(Visit& a, Visit& b)
    {
        if (b < a) {
            const Visit c = a;
            a = b;
            b = c;
        }
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

    // A node that waits is fetched meanwhile.
    static void prefetch(const View& tree, Child node)
    {
        const char* const lines = reinterpret_cast<const char*>(tree.nodes) + node * childUnit;
        for (unsigned i = 0; i < sizeof(Node); i += 64)
            __builtin_prefetch(lines + i);
    }
};

}
