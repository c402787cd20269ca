#pragma once
#include "accel/wide/tree.h"
#include "bvh_interface.h"
#include <atomic>
#include <mutex>

namespace accel {

// The library's tree over primitives, built by the first thread that asks for it: whoever traverses by code of their
// own does not pay for it.
class TreeOnDemand {
public:
    [[nodiscard]] const WideTree* get(std::span<const BVHInterface::Primitive> primitives)
    {
        if (const WideTree* tree = m_built.load(std::memory_order_acquire))
            return tree;
        return build(primitives);
    }

private:
    const WideTree* build(std::span<const BVHInterface::Primitive> primitives);

    std::mutex m_mutex;
    std::unique_ptr<const WideTree> m_tree;
    std::atomic<const WideTree*> m_built = nullptr; // the tree, once it is there
};

}
