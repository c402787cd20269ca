// The probe that follows one ray.
#include "bvh.h"
#include "debug/projection.h"
#include "recursive.h"
#include "render.h"
#include "texture.h"
#include "worker/debug_ray.h"
#include "worker/middle_ray.h"
#include <stdexcept>

namespace worker {
namespace {

    void check(glm::ivec2 pixel, glm::ivec2 size)
    {
        if (glm::any(glm::lessThan(pixel, glm::ivec2(0))) || glm::any(glm::greaterThanEqual(pixel, size)))
            throw std::invalid_argument("found the pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y)
                + ", expected one of a picture of " + std::to_string(size.x) + " x " + std::to_string(size.y));
    }

    std::vector<TextureLookup> describe(
        const std::vector<debug::Lookup>& lookups, const Scene& scene, const Features& features)
    {
        constexpr std::size_t most = 100; // each asks the submission's function a few hundred times
        const debug::SampleTexture sample
            = features.enableBilinearTextureFiltering ? sampleTextureBilinear : sampleTextureNearest;
        std::vector<TextureLookup> described;
        for (const auto& [image, texCoord, cause] : lookups) {
            if (described.size() == most)
                break;
            const auto isKnown = [&](const TextureLookup& known) {
                return known.texCoord == texCoord && known.cause == cause; // it is looked up again for each light
            };
            if (std::ranges::any_of(described, isKnown))
                continue;
            const auto texture = std::ranges::find_if(
                scene.textures, [image = image](const auto& owned) { return owned.get() == image; });
            const glm::ivec2 size { image->width, image->height };
            described.push_back({ static_cast<uint32_t>(texture - scene.textures.begin()), size, texCoord, cause,
                debug::texelsOf(sample, size, texCoord) });
        }
        return described;
    }

    // Where the pixel's rays go through it.
    std::vector<glm::vec2> samplesOf(RenderState& state, const Trackball& camera, glm::ivec2 pixel, glm::ivec2 size)
    {
        const debug::Projection projection { camera, size };
        std::vector<glm::vec2> samples;
        for (const Ray& ray : generatePixelRays(state, camera, pixel, size))
            if (const auto point = projection.point(camera.position() + ray.direction))
                samples.push_back(*point - glm::vec2(pixel));
        return samples;
    }

}

DebugRay followRay(const Scene& scene, const Features& features, const BVHInterface& bvh, const Trackball& camera,
    glm::ivec2 pixel, glm::ivec2 size)
{
    check(pixel, size);
    Features drawing = features;
    drawing.enableDebugDraw = true;
    RenderState state { scene, drawing, bvh, Sampler(1) };
    DebugRay answer { .size = size, .pixel = pixel, .camera = camera };
    const debug::Recording recording;
    answer.color = renderRay(state, middleRay(camera, pixel, size), 0);
    answer.shapes = recording.shapes();
    answer.hits = recording.hits();
    answer.lookups = describe(recording.lookups(), scene, features);
    answer.samples = samplesOf(state, camera, pixel, size);
    answer.numDropped = recording.numDropped();
    return answer;
}

}
