#pragma once
#include "common.h"

namespace accel {

// A ray as the box test wants it: divisions once a ray.
struct RayForBoxes {
    explicit RayForBoxes(const Ray& ray)
        : origin(ray.origin)
        , inverse(1.0f / glm::mix(ray.direction, glm::vec3(0.0f), isNextToNothing(ray.direction)))
    {
    }

    // Zeros of either sign, and what is so small that its reciprocal may be no float.
    static glm::bvec3 isNextToNothing(const glm::vec3& direction)
    {
        return glm::lessThan(glm::abs(direction), glm::vec3(std::numeric_limits<float>::min()));
    }

    glm::vec3 origin;
    glm::vec3 inverse; // positive infinity along axes that the ray does not move on
};

// Bound on the relative error of the three roundings behind a slab's distance. Ize 2013, "Robust BVH Ray Traversal".
inline constexpr float slabRounding = 1.0f + 6.0f * std::numeric_limits<float>::epsilon() / 2.0f;

// Whether the ray is in the box somewhere in [0, tMax]; entry becomes where that begins. Kay and Kajiya 1986.
// An origin on a slab's face and a zero direction give 0 * infinity: in this order of the operands NaN loses every
// comparison, and the face belongs to the box.
[[nodiscard]] inline bool testBox(const AxisAlignedBox& box, const RayForBoxes& ray, float tMax, float& entry)
{
    const glm::vec3 toLower = (box.lower - ray.origin) * ray.inverse;
    const glm::vec3 toUpper = (box.upper - ray.origin) * ray.inverse;
    const glm::vec3 in = glm::min(toLower, toUpper);
    const glm::vec3 out = glm::max(toUpper, toLower);
    entry = std::max(std::max(std::max(0.0f, in.x), in.y), in.z);
    const float exit = std::min(std::min(std::min(std::numeric_limits<float>::max(), out.x), out.y), out.z);
    return entry <= std::min(tMax, exit * slabRounding);
}

}
