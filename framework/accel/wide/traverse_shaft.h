#pragma once
#include "accel/wide/kernels.h"
#include "accel/wide/shaft_test.h"
#include "accel/wide/visits.h"

namespace accel::wide {

// The traversal by a shaft. As Traversal, all is in a template of the instruction set.
template <typename Simd> class ShaftTraversal {
    using Visits = wide::Visits<Simd>;
    using Test = ShaftTest<Simd>;

public:
    static bool isClear(const View& tree, const Shaft& shaft)
    {
        const Test test(tree, shaft);
        return test.isReliable() && (tree.numNodes == 0 ? areBlocksClear(tree, test) : areNodesClear(tree, test));
    }

private:
    static constexpr int mostNodes = 32; // those of a few rays: to look farther would not pay

    static bool areBlocksClear(const View& tree, const Test& test)
    {
        for (uint32_t i = 0; i < tree.numBlocks; ++i)
            if (test.mayMeet(tree.blocks[i]))
                return false;
        return true;
    }

    static bool areNodesClear(const View& tree, const Test& test)
    {
        Child stack[maxDepth * (width - 1) + width];
        Child* top = stack;
        *top++ = 0;
        for (int i = 0; i < mostNodes; ++i) {
            const Node& node = Visits::nodeAt(tree, *--top);
            for (unsigned children = test.mayMeet(node); children != 0; children &= children - 1) {
                const Child child = node.children[__builtin_ctz(children)];
                if ((child & blockBit) == 0)
                    *top++ = child;
                else if (test.mayMeet(Visits::blockAt(tree, child)))
                    return false;
            }
            if (top == stack)
                return true;
        }
        return false;
    }
};

}
