#include "adaptive/pixel_rays.h"
#include "accel/expected_rays.h"
#include "recursive.h"
#include "render.h"
#include "values/even_numbers.h"
#include "values/needs_of.h"

namespace adaptive {
namespace {

    Features oneSampleEach(Features features)
    {
        features.enableJitteredSampling = false; // would not return as many rays; the numbers are spread already
        features.numShadowSamples = 1;
        features.extra.numGlossySamples = 1;
        return features;
    }

}

PixelRays::PixelRays(const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera,
    glm::ivec2 size, uint32_t seed)
    : m_scene(scene)
    , m_bvh(bvh)
    , m_features(oneSampleEach(features))
    , m_needs(values::needsOf(scene, m_features))
    , m_camera(camera)
    , m_size(size)
    , m_seed((seed + 1) * 0x9e3779b9u) // others than renderImage's: either can judge the other
{
}

glm::dvec3 PixelRays::mean(std::size_t pixel, uint32_t firstRay, uint32_t numRays) const
{
    constexpr uint32_t mostAtOnce = 256; // lest a million rays want memory
    Features features = m_features;
    features.numPixelSamples = std::min(numRays, mostAtOnce);
    const uint32_t numTimes = numRays / features.numPixelSamples;
    glm::dvec3 sum(0.0);
    for (uint32_t i = 0; i < numTimes; ++i)
        sum += meanOfFew(features, pixel, firstRay + i * features.numPixelSamples);
    return sum / static_cast<double>(numTimes);
}

glm::dvec3 PixelRays::meanOfFew(const Features& features, std::size_t pixel, uint32_t firstRay) const
{
    values::EvenNumbers even(m_seed + static_cast<uint32_t>(pixel), values::EvenNumbers::Method::Owen, firstRay);
    RenderState state { m_scene, features, m_bvh, Sampler(even), m_needs };
    accel::ExpectedRays expected;
    if (features.extra.enableSkipping)
        state.expected = &expected;
    const auto width = static_cast<std::size_t>(m_size.x);
    const glm::ivec2 place(static_cast<int>(pixel % width), static_cast<int>(pixel / width));
    return glm::dvec3(renderRays(state, generatePixelRays(state, m_camera, place, m_size)));
}

}
