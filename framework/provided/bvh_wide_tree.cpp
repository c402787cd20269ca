#include "accel/wide/tree_on_demand.h"
#include "bvh.h"

const accel::WideTree* BVH::wideTree() const
{
    return m_wideTree ? m_wideTree->get(*this) : nullptr;
}
