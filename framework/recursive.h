#pragma once
#include "common.h"
#include "fwd.h"
#include "render.h"
#include <framework/ray.h>
#include <span>

// Provided: the mean of the light along the rays.
[[nodiscard]] glm::vec3 renderRays(RenderState& state, std::span<const Ray> rays, int rayDepth = 0);

// Provided: the light along a ray. Below depth 6 (features.extra.maxDepth) adds the mirrored light and
// blends with what lies behind.
[[nodiscard]] glm::vec3 renderRay(RenderState& state, Ray ray, int rayDepth = 0);

// To implement: from the hit point, the direction mirrored about the normal, unit; t = FLT_MAX. The origin is moved
// off the surface, by 1e-5 to 1e-3 of the scene's size, so that the ray does not meet it again.
[[nodiscard]] Ray generateReflectionRay(Ray ray, HitInfo hitInfo);

// To implement: from the hit point onwards in the ray's direction; t = FLT_MAX. The origin is moved past the surface.
[[nodiscard]] Ray generatePassthroughRay(Ray ray, HitInfo hitInfo);

// To implement: hitColor += ks * light along the reflected ray, at depth rayDepth + 1.
void renderRaySpecularComponent(RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth);

// To implement: hitColor = hitColor * alpha + light from behind * (1 - alpha), at depth rayDepth + 1, where alpha is
// the material's transparency: 1 is opaque.
void renderRayTransparentComponent(
    RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth);
