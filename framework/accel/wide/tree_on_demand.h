#pragma once
#include "accel/wide/tree.h"
#include "bvh_interface.h"
#include <atomic>
#include <mutex>

namespace accel {

// The library's tree over another's primitives, built by the first thread that asks for it: whoever traverses by code
// of their own does not pay for it.
class TreeOnDemand {
public:
    [[nodiscard]] const WideTree* get(const BVHInterface& bvh)
    {
        if (const WideTree* tree = m_built.load(std::memory_order_acquire))
            return tree;
        return build(bvh);
    }

private:
    const WideTree* build(const BVHInterface& bvh);

    std::mutex m_mutex;
    std::unique_ptr<const WideTree> m_tree;
    std::atomic<const WideTree*> m_built = nullptr; // the tree, once it is there
};

}
