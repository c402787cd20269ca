// Mirrors and see-through surfaces: at a hit the ray goes on, reflected or straight through.
//
// To read: Whitted 1980, "An Improved Illumination Model for Shaded Display"; Marschner and Shirley, "Fundamentals of
// Computer Graphics", chapter "Ray Tracing"; Pharr, Jakob and Humphreys, "Physically Based Rendering" (4th edition),
// 6.8 "Managing Rounding Error". Provided, declared in recursive.h: renderRay, which calls the components below.
#include "recursive.h"
#include "draw.h"
#include "not_written_yet.h"

#pragma GCC diagnostic ignored "-Wunused-parameter" // delete this line when the whole file is written

// The mirrored ray: from the hit point ray.origin + ray.t * ray.direction in direction r = d - 2 * dot(d, n) * n,
// unit, with t = FLT_MAX.
//
// - The hit point is rounded and may lie behind the surface: a ray that starts just there meets the same surface
//   again (dark dots, "acne"). Move the origin off the surface, by 1e-5 to 1e-3 of the scene's size: too little
//   leaves the dots, too much looks through corners.
// - ray is a copy, with the t of the hit in it.
Ray generateReflectionRay(Ray ray, HitInfo hitInfo)
{
    notWrittenYet("generateReflectionRay"); // delete this line when the function is written
    return ray;
}

// The ray that goes on behind the surface: same direction, from the hit point, with t = FLT_MAX.
//
// - Here the origin must be past the surface, by as much as above: on which side is that?
// - glm adds a float to a vector component by component: point + 1e-4f moves along (1, 1, 1), wherever the ray goes.
Ray generatePassthroughRay(Ray ray, HitInfo hitInfo)
{
    notWrittenYet("generatePassthroughRay"); // delete this line when the function is written
    return ray;
}

// hitColor += ks * (light along the reflected ray), which renderRay computes, at depth rayDepth + 1.
//
// - renderRay stops at a depth of 6: with a depth that does not grow, two mirrors never end.
// - Colours are not clamped here, only when the picture is written.
// - Debug drawing: the normal at the hit yellow, the reflected ray green. For example
//   drawRay(Ray { point, hitInfo.normal, 0.2f }, glm::vec3(1.0f, 1.0f, 0.0f));
//   draws a normal of length 0.2. Such calls can stay: they cost next to nothing while nobody looks.
void renderRaySpecularComponent(RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth)
{
    notWrittenYet("renderRaySpecularComponent"); // delete this line when the function is written
}

// Alpha blending, hitColor = hitColor * alpha + behind * (1 - alpha), where behind is the light along the passthrough
// ray at depth rayDepth + 1. Porter and Duff 1984, "Compositing Digital Images", the operator "over".
//
// - alpha is hitInfo.material.transparency, whose name says the opposite: 1 is opaque, 0 lets everything through.
// - hitColor already holds shading and reflection: it is blended as a whole, nothing is added on top.
// - Debug drawing: the passthrough ray in the blended colour, and a small sphere of colour kd * alpha at the hit.
void renderRayTransparentComponent(
    RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth)
{
    notWrittenYet("renderRayTransparentComponent"); // delete this line when the function is written
}
