#include "accel/wide/tree_on_demand.h"
#include "accel/kept_trees.h"
#include <tbb/task_arena.h>

namespace accel {

static WideTree::Triangle triangleOf(const void* bvh, uint32_t index)
{
    BVHInterface::Primitive room;
    const auto& [meshID, v0, v1, v2] = static_cast<const BVHInterface*>(bvh)->primitive(index, room);
    return { v0.position, v1.position, v2.position };
}

const WideTree* TreeOnDemand::build(const BVHInterface& bvh)
{
    const std::lock_guard lock(m_mutex);
    if (!m_tree) {
        const WideTree::Triangles triangles(&bvh, bvh.numPrimitives(), triangleOf);
        // Isolated: a thread that waits for its part of the building must not take up a pixel, which would ask again.
        const files::KeptArrays* const kept = keptTrees(triangles.size());
        tbb::this_task_arena::isolate([&] {
            m_tree = std::make_unique<const WideTree>(kept ? WideTree::keptIn(*kept, triangles) : WideTree(triangles));
        });
        m_built.store(m_tree.get(), std::memory_order_release);
    }
    return m_tree.get();
}

}
