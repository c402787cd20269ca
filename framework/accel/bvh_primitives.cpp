#include "bvh_primitives.h"
#include "accel/scene_triangles.h"
#include <mutex>

struct BVHPrimitives::Order {
    accel::SceneTriangles triangles;
    std::vector<uint32_t> indices;
};

BVHPrimitives::BVHPrimitives() = default;
BVHPrimitives::~BVHPrimitives() = default;

BVHPrimitives::BVHPrimitives(accel::SceneTriangles triangles, std::vector<uint32_t> order)
    : m_order(std::make_unique<const Order>(std::move(triangles), std::move(order)))
    , m_isMade(false)
{
}

BVHPrimitives::BVHPrimitives(BVHPrimitives&& other) noexcept
    : m_order(std::move(other.m_order))
    , m_made(std::move(other.m_made))
    , m_isMade(other.m_isMade.exchange(true))
{
}

BVHPrimitives& BVHPrimitives::operator=(BVHPrimitives&& other) noexcept
{
    m_order = std::move(other.m_order);
    m_made = std::move(other.m_made);
    m_isMade = other.m_isMade.exchange(true);
    return *this;
}

BVHPrimitives::size_type BVHPrimitives::numUnmade() const
{
    return m_order->indices.size();
}

BVHInterface::Primitive BVHPrimitives::makeOne(size_type i) const
{
    return m_order->triangles[m_order->indices[i]];
}

// The order stays: other threads may be making one alone.
void BVHPrimitives::makeAll() const
{
    static std::mutex mutex; // of all trees: nobody makes two at once
    const std::lock_guard lock(mutex);
    if (m_isMade)
        return;
    m_made.reserve(numUnmade());
    for (size_type i = 0; i < numUnmade(); ++i)
        m_made.push_back(makeOne(i));
    m_isMade = true;
}
