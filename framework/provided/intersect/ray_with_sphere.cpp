#include "accel/sphere_test.h"
#include "intersect.h"

bool intersectRayWithShape(const Sphere& sphere, Ray& ray, HitInfo& hitInfo)
{
    const float t = accel::firstDistance(sphere, ray);
    if (!(t >= 0.0f && t <= ray.t))
        return false;
    ray.t = t;
    const glm::vec3 outwards = glm::normalize(ray.origin + t * ray.direction - sphere.center);
    hitInfo.normal = glm::dot(outwards, ray.direction) > 0.0f ? -outwards : outwards;
    hitInfo.barycentricCoord = glm::vec3(0.0f);
    hitInfo.texCoord = glm::vec2(0.0f);
    hitInfo.material = sphere.material;
    return true;
}
