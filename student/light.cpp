// Lights and shadows: how much light of each source arrives at the shaded point, and what it does there.
//
// In all functions the shaded point is ray.origin + ray.t * ray.direction, and hitInfo describes its surface.
//
// To read: Cook, Porter and Carpenter 1984, "Distributed Ray Tracing"; Marschner and Shirley, "Fundamentals of
// Computer Graphics", chapter "Ray Tracing", section "Shadows"; Pharr, Jakob and Humphreys, "Physically Based
// Rendering" (4th edition), 6.8 "Managing Rounding Error". Provided: visibilityOfLightSample and
// computeLightContribution (light.h), computeShading (shading.h). What a ray meets:
// state.bvh.intersect(state, ray, hitInfo).
#include "light.h"
#include "bvh_interface.h"
#include "draw.h"
#include "not_written_yet.h"
#include "scene.h"
#include "shading.h"

#pragma GCC diagnostic ignored "-Wunused-parameter" // delete this line when the whole file is written

// The point at a fraction sample in [0, 1) of the way from endpoint0 to endpoint1, and the colour blended alike.
// The random number is given: this function asks for none.
void sampleSegmentLight(const float& sample, const SegmentLight& light, glm::vec3& position, glm::vec3& color)
{
    notWrittenYet("sampleSegmentLight"); // delete this line when the function is written
    position = light.endpoint0;
    color = light.color0;
}

// The point v0 + sample.x * edge01 + sample.y * edge02, and the colour blended bilinearly between the corners: color0
// at v0, color1 at v0 + edge01, color2 at v0 + edge02, color3 opposite v0.
//
// - edge01 and edge02 are vectors from v0, not points.
// - Put a corner's sample in: the result must be that corner's colour and no other.
void sampleParallelogramLight(
    const glm::vec2& sample, const ParallelogramLight& light, glm::vec3& position, glm::vec3& color)
{
    notWrittenYet("sampleParallelogramLight"); // delete this line when the function is written
    position = light.v0;
    color = light.color0;
}

// A hard shadow: whether nothing lies between the shaded point and the light. Called when shadows are on.
//
// - What lies beyond the light casts no shadow. A ray ends at its t: in which unit?
// - The shaded point's own surface must not shadow it, and things that touch must not let light in: keep off the ends
//   by 1e-5 to 1e-3 of the scene's size. (Adding a float to a vector moves along (1, 1, 1).)
bool visibilityOfLightSampleBinary(RenderState& state, const glm::vec3& lightPosition, const glm::vec3& lightColor,
    const Ray& ray, const HitInfo& hitInfo)
{
    notWrittenYet("visibilityOfLightSampleBinary"); // delete this line when the function is written
    return true;
}

// The colour that is left of lightColor at the shaded point: each surface in between multiplies it by
// kd * (1 - alpha), alpha = material.transparency, 1 is opaque. Called when shadows and transparency are on.
//
// - There may be any number of surfaces in between: go on behind each, and make sure that every step gets closer to
//   the light, or the loop never ends. After an opaque one nothing is left.
// - It is the kd of the surface in between, and sampleMaterialKd knows whether that has a texture.
// - The report asks when this formula is plausible; at alpha 0, 0.5 and 1, what would you have expected?
glm::vec3 visibilityOfLightSampleTransparency(RenderState& state, const glm::vec3& lightPosition,
    const glm::vec3& lightColor, const Ray& ray, const HitInfo& hitInfo)
{
    notWrittenYet("visibilityOfLightSampleTransparency"); // delete this line when the function is written
    return lightColor;
}

// What the point light adds: computeShading with the part of its colour that visibilityOfLightSample lets through.
//
// - Here the light is never blocked: that is what is missing.
// - visibilityOfLightSample gives a colour, of which the light's own is part already.
// - Debug drawing: the direction to the light in red, from the shaded point.
glm::vec3 computeContributionPointLight(
    RenderState& state, const PointLight& light, const Ray& ray, const HitInfo& hitInfo)
{
    notWrittenYet("computeContributionPointLight"); // delete this line when the function is written
    const glm::vec3 point = ray.origin + ray.t * ray.direction;
    const glm::vec3 lightDirection = glm::normalize(light.position - point);
    const glm::vec3 cameraDirection = -glm::normalize(ray.direction);
    return computeShading(state, cameraDirection, lightDirection, light.color, hitInfo);
}

// A soft shadow: the mean of the contributions of numSamples points of the light, each visible or not by itself.
//
// - Random numbers come from state.sampler.next_1d(), a new one for each sample. std::rand and generators of your own
//   make pictures that differ from run to run.
// - It is the results that are averaged, not the positions or colours of the samples.
// - Area lights neither fade with distance nor with the angle at the light.
// - Debug drawing: the direction to each sample in red.
glm::vec3 computeContributionSegmentLight(
    RenderState& state, const SegmentLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples)
{
    notWrittenYet("computeContributionSegmentLight"); // delete this line when the function is written
    return computeContributionPointLight(state, { light.endpoint0, light.color0 }, ray, hitInfo);
}

// The same over the parallelogram, with two random numbers a sample: state.sampler.next_2d().
glm::vec3 computeContributionParallelogramLight(
    RenderState& state, const ParallelogramLight& light, const Ray& ray, const HitInfo& hitInfo, uint32_t numSamples)
{
    notWrittenYet("computeContributionParallelogramLight"); // delete this line when the function is written
    return computeContributionPointLight(state, { light.v0, light.color0 }, ray, hitInfo);
}
