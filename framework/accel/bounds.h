#pragma once
#include "bvh_interface.h"
#include "common.h"

namespace accel {

// A box that holds nothing: whatever is united with it is the result.
[[nodiscard]] inline AxisAlignedBox emptyBox()
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return { glm::vec3(infinity), glm::vec3(-infinity) };
}

[[nodiscard]] inline AxisAlignedBox unite(const AxisAlignedBox& a, const AxisAlignedBox& b)
{
    return { glm::min(a.lower, b.lower), glm::max(a.upper, b.upper) };
}

[[nodiscard]] inline AxisAlignedBox unite(const AxisAlignedBox& box, const glm::vec3& point)
{
    return unite(box, AxisAlignedBox { point, point });
}

[[nodiscard]] inline AxisAlignedBox boundsOf(const BVHInterface::Primitive& triangle)
{
    const AxisAlignedBox first { triangle.v0.position, triangle.v0.position };
    return unite(unite(first, triangle.v1.position), triangle.v2.position);
}

// Half the surface of a box that is not empty.
[[nodiscard]] inline float halfArea(const AxisAlignedBox& box)
{
    const glm::vec3 size = box.upper - box.lower;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

}
