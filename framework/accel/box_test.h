#pragma once
#include "common.h"

namespace accel {

// A ray as the box test wants it: divisions once a ray.
struct RayForBoxes {
    explicit RayForBoxes(const Ray& ray)
        : origin(ray.origin)
        , inverse(1.0f / ray.direction)
    {
    }

    glm::vec3 origin;
    glm::vec3 inverse; // infinite along axes that the ray does not move on
};

// Bound on the relative error of the three roundings behind a slab's distance. Ize 2013, "Robust BVH Ray Traversal".
inline constexpr float slabRounding = 1.0f + 6.0f * std::numeric_limits<float>::epsilon() / 2.0f;

// Whether the ray is in the box somewhere in [0, tMax]; entry becomes where that begins. Kay and Kajiya 1986.
// Where an origin on a slab's face meets a zero direction the distance is NaN: the comparisons below then keep the
// bound that they had, so that the face belongs to the box.
[[nodiscard]] inline bool testBox(const AxisAlignedBox& box, const RayForBoxes& ray, float tMax, float& entry)
{
    float tNear = 0.0f;
    float tFar = tMax;
    for (int axis = 0; axis < 3; ++axis) {
        const float toLower = (box.lower[axis] - ray.origin[axis]) * ray.inverse[axis];
        const float toUpper = (box.upper[axis] - ray.origin[axis]) * ray.inverse[axis];
        const bool forwards = ray.inverse[axis] >= 0.0f;
        const float in = forwards ? toLower : toUpper;
        const float out = (forwards ? toUpper : toLower) * slabRounding;
        tNear = in > tNear ? in : tNear;
        tFar = out < tFar ? out : tFar;
    }
    entry = tNear;
    return tNear <= tFar;
}

}
