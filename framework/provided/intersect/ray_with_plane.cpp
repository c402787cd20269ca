#include "intersect.h"

bool intersectRayWithPlane(const Plane& plane, Ray& ray)
{
    const float t = (plane.D - glm::dot(ray.origin, plane.normal)) / glm::dot(ray.direction, plane.normal);
    if (!(t >= 0.0f && t <= ray.t)) // a parallel ray gives infinity or NaN
        return false;
    ray.t = t;
    return true;
}
