#include "render.h"
#include "bvh.h"
#include "debug/projection.h"
#include "report/probes/pixel_question.h"
#include "scene.h"
#include "worker/probe.h"
#include <framework/trackball.h>

namespace report {
namespace {

    // PixelQuestion -> PixelSamples
    const worker::Probe samples("figures.pixel_samples", [](worker::Call& call) {
        const auto question = call.input.read<PixelQuestion>();
        const glm::ivec2 size = question.size;
        const Trackball camera(0.87f, 3.0f, static_cast<float>(size.x) / static_cast<float>(size.y));
        const debug::Projection projection(camera, size);
        const Scene scene;
        Features features;
        features.numPixelSamples = question.numSamples;
        const BVH bvh(scene, features);
        const auto generate = question.isStratified ? generatePixelRaysStratified : generatePixelRaysUniform;
        PixelSamples places;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const auto numBefore = static_cast<uint32_t>(places.size());
                RenderState state { scene, features, bvh,
                    Sampler(question.seed * static_cast<uint32_t>(size.x * size.y) + numBefore) };
                std::vector<glm::vec2>& inPixel = places.emplace_back();
                for (const Ray& ray : generate(state, camera, { x, y }, size))
                    if (const auto place = projection.point(ray.origin + ray.direction))
                        inPixel.push_back(*place);
            }
        call.output << places;
    });

}
}
