#pragma once
#include "common.h"
#include "fwd.h"
#include "sampler.h"
#include "scene_needs.h"
#include <framework/ray.h>
#include <span>
#include <vector>

namespace accel {
class ExpectedRays;
class LightShaft;
}

// What every function of the renderer can look at, and the random numbers of one pixel.
struct RenderState {
    const Scene& scene;
    const Features& features;
    const BVHInterface& bvh;

    Sampler sampler;
    SceneNeeds needs {};
    accel::ExpectedRays* expected = nullptr; // whose closest hits are asked for next, if that is known
    accel::LightShaft* shaft = nullptr; // whether anything lies on the way to an area light; null: rays tell
};

// Provided: renders all pixels, on all cores, with the same result for any number of threads.
void renderImage(
    const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera, Screen& screen);

// Provided: the camera rays of a pixel, by the sampling that the features select; one sample goes through the centre.
[[nodiscard]] std::vector<Ray> generatePixelRays(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution);

// To implement: features.numPixelSamples camera rays, each through an independent uniform point of
// [x, x+1) x [y, y+1) of the resolution.
[[nodiscard]] std::vector<Ray> generatePixelRaysUniform(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution);

// To implement: n x n camera rays, n = round(sqrt(features.numPixelSamples)), each through a uniform point of its own
// cell of the pixel's n x n grid.
[[nodiscard]] std::vector<Ray> generatePixelRaysStratified(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution);

// The name of generatePixelRaysUniform in the 2023-24 edition.
[[nodiscard]] std::vector<Ray> generatePixelRaysMultisampled(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution);
