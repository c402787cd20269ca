// Several rays a pixel, so that edges come out smooth.
//
// Pixel (x, y) covers [x, x+1) x [y, y+1) of the resolution. camera.generateRay takes the point in other units:
// (-1, -1) is the bottom left of the screen, (1, 1) the top right.
//
// To read: Pharr, Jakob and Humphreys, "Physically Based Rendering" (4th edition), 2.2.1 "Stratified Sampling" and
// 8.5 "Stratified Sampler"; Cook, Porter and Carpenter 1984, "Distributed Ray Tracing". Provided, declared in
// render.h: renderImage, and generatePixelRays, which chooses one of the two below.
#include "render.h"
#include "not_written_yet.h"
#include <framework/trackball.h>

// state.features.numPixelSamples rays, each through a uniform random point of the pixel, independent of the others.
//
// - Random numbers in [0, 1) come from state.sampler.next_1d() and next_2d(). One number for both x and y puts all
//   points onto a diagonal.
// - Below is the ray through the pixel's centre, with the conversion to [-1, 1]. A division of two glm::ivec2 would
//   be one of integers: 3 / 4 is 0.
std::vector<Ray> generatePixelRaysUniform(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    notWrittenYet("generatePixelRaysUniform"); // delete this line when the function is written
    const glm::vec2 centre = (glm::vec2(pixel) + 0.5f) / glm::vec2(screenResolution) * 2.0f - 1.0f;
    return std::vector<Ray>(state.features.numPixelSamples, camera.generateRay(centre));
}

// n x n rays, n = round(sqrt(state.features.numPixelSamples)): the pixel is cut into n x n equal cells, and each
// cell gets one ray, through a uniform random point of that cell.
//
// - numPixelSamples is the number of rays, not n: with 9 there are 3 x 3 cells, each a third of a pixel wide.
// - The random offset reaches across the whole cell, and no further.
// - i / n with two integers is 0 for every cell.
std::vector<Ray> generatePixelRaysStratified(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    notWrittenYet("generatePixelRaysStratified"); // delete this line when the function is written
    const glm::vec2 centre = (glm::vec2(pixel) + 0.5f) / glm::vec2(screenResolution) * 2.0f - 1.0f;
    return std::vector<Ray>(state.features.numPixelSamples, camera.generateRay(centre));
}
