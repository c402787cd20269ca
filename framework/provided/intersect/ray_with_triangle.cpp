#include "accel/triangle_test.h"
#include "debug/tally.h"
#include "intersect.h"

bool intersectRayWithTriangle(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, Ray& ray, HitInfo& hitInfo)
{
    debug::Tally::addTriangles(1);
    accel::TriangleHit hit;
    if (!accel::testTriangle(v0, v1, v2, ray, hit))
        return false;
    ray.t = hit.t;
    hitInfo.normal = glm::normalize(glm::dot(hit.normal, ray.direction) > 0.0f ? -hit.normal : hit.normal);
    return true;
}
