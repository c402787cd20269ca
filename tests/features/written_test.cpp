#include "interpolate.h"
#include "light.h"
#include "recursive.h"
#include "shading.h"
#include "texture.h"
#include "values/unwritten.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <framework/trackball.h>

using namespace tests;

TEST_CASE("No function of the interface is still a stub", "[features]")
{
    Scene scene;
    addPane(scene, { .kd = glm::vec3(0.5f) }, 0.0f);
    World world(std::move(scene), { .enableShadows = true, .enableAccelStructure = true, .numPixelSamples = 4 });
    RenderState& state = world.state;
    const glm::vec3 up { 0, 0, 1 }, one { 1.0f };
    const SegmentLight segment { up, one, one, one };
    const ParallelogramLight parallelogram { up, one, one, one, one, one, one };
    glm::vec3 position, color;
    (void)values::takeUnwritten(); // of tests before this one

    Ray ray { up, -up };
    HitInfo hit {};
    REQUIRE(world.bvh.intersect(state, ray, hit));
    (void)LinearGradient {}.sample(0.0f);
    (void)computeLinearGradientModel(state, up, up, one, hit, {});
    (void)computeLinearGradientModelComparison(state, up, up, one, hit, {});
    (void)generateReflectionRay(ray, hit);
    (void)generatePassthroughRay(ray, hit);
    renderRaySpecularComponent(state, ray, hit, color, 0);
    renderRayTransparentComponent(state, ray, hit, color, 0);
    (void)computeBarycentricCoord(up, one, position, one);
    (void)interpolateNormal(up, up, up, one);
    (void)interpolateTexCoord({}, {}, {}, one);
    (void)sampleTextureNearest(Image(1, 1), {});
    (void)sampleTextureBilinear(Image(1, 1), {});
    sampleSegmentLight(0.5f, segment, position, color);
    sampleParallelogramLight({}, parallelogram, position, color);
    (void)visibilityOfLightSampleBinary(state, up, one, ray, hit);
    (void)visibilityOfLightSampleTransparency(state, up, one, ray, hit);
    (void)computeContributionPointLight(state, { up, one }, ray, hit);
    (void)computeContributionSegmentLight(state, segment, ray, hit, 1);
    (void)computeContributionParallelogramLight(state, parallelogram, ray, hit, 1);
    (void)generatePixelRaysUniform(state, Trackball(), {}, { 1, 1 });
    (void)generatePixelRaysStratified(state, Trackball(), {}, { 1, 1 });

    CHECK(values::takeUnwritten() == std::vector<std::string> {});
}
