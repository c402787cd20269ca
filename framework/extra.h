#pragma once
#include "bvh_interface.h"
#include "fwd.h"
#include "render.h"
#include "scene.h"
#include "screen.h"
#include <framework/trackball.h>

// Extensions, each behind its switch in ExtraFeatures. To implement, by whoever wants to, in extra.cpp or in a file of
// its own in extra/; one that nobody wrote leaves the image as it is without it.

void renderImageWithDepthOfField(
    const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera, Screen& screen);
void renderImageWithMotionBlur(
    const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera, Screen& screen);

// Changes the finished picture.
void postprocessImageWithBloom(const Scene& scene, const Features& features, const Trackball& camera, Screen& screen);

// Like renderRaySpecularComponent, with the mean of features.extra.numGlossySamples scattered rays.
void renderRayGlossyComponent(RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth);

// The light along a ray that hits nothing.
[[nodiscard]] glm::vec3 sampleEnvironmentMap(RenderState& state, Ray ray);

// For those who bring a builder of their own (BVH::BVH): ours does not call it. Reorders the primitives so that the
// first of them, as many as it returns, are the left child by the surface area heuristic.
size_t splitPrimitivesBySAHBin(
    const AxisAlignedBox& aabb, uint32_t axis, std::span<BVHInterface::Primitive> primitives);
