#pragma once
#include "accel/wide/tree_on_demand.h"
#include "bvh.h"
#include "render.h"

namespace worker {

// The library traverses, whatever the submission would do.
class LibraryBVH final : public BVH {
public:
    using BVH::BVH;

    bool intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const override
    {
        return intersectRayWithBVH(state, *this, ray, hitInfo);
    }

    bool isOccluded(RenderState& state, const Ray& ray) const override
    {
        return state.features.extra.enableSkipping ? isOccludedByBVH(state, *this, ray) : BVH::isOccluded(state, ray);
    }

    // Its own, since a submission that builds the binary tree itself has none.
    [[nodiscard]] const accel::WideTree* wideTree() const override { return m_tree.get(*this); }

private:
    mutable accel::TreeOnDemand m_tree;
};

}
