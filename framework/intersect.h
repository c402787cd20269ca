#pragma once
#include "common.h"
#include "fwd.h"
#include <framework/ray.h>

// Provided. Each tells whether the ray meets the shape at a distance in [0, ray.t]; if so ray.t becomes that distance.
// All shapes have two sides, edges belong to them, and a normal that is filled faces the incoming ray.

// Of hitInfo, fills the normal. Watertight: no ray slips through an edge that two triangles share.
bool intersectRayWithTriangle(
    const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, Ray& ray, HitInfo& hitInfo);

// Fills all of hitInfo.
bool intersectRayWithShape(const Sphere& sphere, Ray& ray, HitInfo& hitInfo);

// The solid box: a ray that starts inside meets it at 0.
bool intersectRayWithShape(const AxisAlignedBox& box, Ray& ray);

bool intersectRayWithPlane(const Plane& plane, Ray& ray);

// Whether p, a point of the triangle's plane with the unit normal n, lies in the triangle.
[[nodiscard]] bool pointInTriangle(
    const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& n, const glm::vec3& p);

[[nodiscard]] Plane trianglePlane(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2);
