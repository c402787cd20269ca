#pragma once
#include "bvh_interface.h"
#include <utility>

namespace accel {

// Another's tree, for whoever wants to know of its rays or to traverse it in a way of their own.
class WrappedBVH : public BVHInterface {
public:
    explicit WrappedBVH(BVHInterface& bvh)
        : m_bvh(bvh)
    {
    }

    [[nodiscard]] std::span<const Node> nodes() const override { return std::as_const(m_bvh).nodes(); }
    [[nodiscard]] std::span<Node> nodes() override { return m_bvh.nodes(); }
    [[nodiscard]] std::span<const Primitive> primitives() const override { return std::as_const(m_bvh).primitives(); }
    [[nodiscard]] std::span<Primitive> primitives() override { return m_bvh.primitives(); }
    [[nodiscard]] std::size_t numPrimitives() const override { return m_bvh.numPrimitives(); }
    [[nodiscard]] const Primitive& primitive(std::size_t index, Primitive& room) const override
    {
        return m_bvh.primitive(index, room);
    }
    [[nodiscard]] uint32_t numLevels() const override { return m_bvh.numLevels(); }
    [[nodiscard]] uint32_t numLeaves() const override { return m_bvh.numLeaves(); }
    [[nodiscard]] const WideTree* wideTree() const override { return m_bvh.wideTree(); }

protected:
    [[nodiscard]] const BVHInterface& wrapped() const { return m_bvh; }

private:
    BVHInterface& m_bvh;
};

}
