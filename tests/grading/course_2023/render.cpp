#include "render.h"
#include "bvh_interface.h"
#include "draw.h"
#include "extra.h"
#include "light.h"
#include "recursive.h"
#include "sampler.h"
#include "screen.h"
#include "shading.h"
#include <framework/trackball.h>
#ifdef NDEBUG
#include <omp.h>
#endif

void renderImage(
    const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera, Screen& screen)
{
    if (features.extra.enableDepthOfField) {
        renderImageWithDepthOfField(scene, bvh, features, camera, screen);
    } else if (features.extra.enableMotionBlur) {
        renderImageWithMotionBlur(scene, bvh, features, camera, screen);
    } else {
#ifdef NDEBUG
#pragma omp parallel for schedule(guided)
#endif
        for (int y = 0; y < screen.resolution().y; y++) {
            for (int x = 0; x != screen.resolution().x; x++) {
                RenderState state = { .scene = scene,
                    .features = features,
                    .bvh = bvh,
                    .sampler = { static_cast<uint32_t>(screen.resolution().y * x + y) } };
                auto rays = generatePixelRays(state, camera, { x, y }, screen.resolution());
                auto L = renderRays(state, rays);
                screen.setPixel(x, y, L);
            }
        }
    }
    if (features.extra.enableBloomEffect) {
        postprocessImageWithBloom(scene, features, camera, screen);
    }
}

std::vector<Ray> generatePixelRays(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    if (state.features.numPixelSamples > 1) {
        if (state.features.enableJitteredSampling) {
            return generatePixelRaysStratified(state, camera, pixel, screenResolution);
        } else {
            return generatePixelRaysMultisampled(state, camera, pixel, screenResolution);
        }
    } else {
        glm::vec2 position = (glm::vec2(pixel) + 0.5f) / glm::vec2(screenResolution) * 2.f - 1.f;
        return { camera.generateRay(position) };
    }
}

std::vector<Ray> generatePixelRaysMultisampled(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    auto numSamples = state.features.numPixelSamples;
    std::vector<Ray> rays;
    for (int i = 0; i < numSamples; i++) {
        glm::vec2 pos(pixel.x + state.sampler.next_1d(), pixel.y + state.sampler.next_1d());
        rays.push_back(camera.generateRay(pos / glm::vec2(screenResolution) * 2.f - 1.f));
    }
    return rays;
}

std::vector<Ray> generatePixelRaysStratified(
    RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 screenResolution)
{
    auto numSamples = static_cast<uint32_t>(std::round(std::sqrt(float(state.features.numPixelSamples))));
    std::vector<Ray> rays;
    for (int i = 0; i < numSamples; i++) {
        for (int j = 0; j < numSamples; j++) {
            glm::vec2 pos(pixel.x + (i + state.sampler.next_1d()) / numSamples,
                pixel.y + (j + state.sampler.next_1d()) / numSamples);
            rays.push_back(camera.generateRay(pos / glm::vec2(screenResolution) * 2.f - 1.f));
        }
    }
    return rays;
}
