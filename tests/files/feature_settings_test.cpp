#include "files/feature_settings.h"
#include <catch2/catch.hpp>
#include <set>

using Catch::Matchers::Contains;
using Catch::Matchers::Equals;

TEST_CASE("Every feature has one name", "[files]")
{
    const auto names = files::featureNames();
    CHECK(names.size() == 25);
    CHECK(std::set(names.begin(), names.end()).size() == names.size());
}

TEST_CASE("Text sets the feature that it names and no other", "[files]")
{
    Features features;
    files::setFeature(features, "normal_interp", "true");
    files::setFeature(features, "motion_blur", "true");
    files::setFeature(features, "shading_model", "linear_gradient_comparison");
    files::setFeature(features, "pixel_samples", "1048576");
    files::setFeature(features, "glossy_samples", "7");
    files::setFeature(features, "max_depth", "0");
    CHECK(features.enableNormalInterp);
    CHECK(features.extra.enableMotionBlur);
    CHECK(features.shadingModel == ShadingModel::LinearGradientComparison);
    CHECK(features.numPixelSamples == 1048576);
    CHECK(features.extra.numGlossySamples == 7);
    CHECK(features.extra.maxDepth == 0);
    CHECK_FALSE(features.enableShading);
    CHECK_FALSE(features.extra.enableBloomEffect);

    files::setFeature(features, "normal_interp", "false");
    CHECK_FALSE(features.enableNormalInterp);
}

TEST_CASE("A feature has the value that was set", "[files]")
{
    Features features;
    CHECK(files::featureValue(features, "bloom") == files::FeatureValue(false));
    CHECK(files::featureValue(features, "shadow_samples") == files::FeatureValue(int64_t { 4 }));
    features.extra.enableBloomEffect = true;
    features.numShadowSamples = 9;
    features.shadingModel = ShadingModel::BlinnPhong;
    CHECK(files::featureValue(features, "bloom") == files::FeatureValue(true));
    CHECK(files::featureValue(features, "shadow_samples") == files::FeatureValue(int64_t { 9 }));
    CHECK(files::featureValue(features, "shading_model") == files::FeatureValue(std::string("blinn_phong")));
}

TEST_CASE("A bad feature is refused with what was found and expected", "[files]")
{
    Features features;
    const auto set = [&](const char* name, const char* value) { files::setFeature(features, name, value); };
    CHECK_THROWS_WITH(set("shading", "yes"), Equals("shading: found \"yes\", expected true or false"));
    CHECK_THROWS_WITH(set("shadows", "1"), Equals("shadows: found 1, expected true or false"));
    const auto expectsCount = Contains("expected a count from 1 to 1048576");
    for (const char* value : { "0", "-1", "1048577", "99999999999999999999", "4.5", "true", "", "4x" })
        CHECK_THROWS_WITH(set("pixel_samples", value), expectsCount);
    CHECK_THROWS_WITH(set("max_depth", "7"), Equals("max_depth: found 7, expected a count from 0 to 6"));
    CHECK_THROWS_WITH(set("shading_model", "Phong"), Contains("found \"Phong\", expected one of lambertian, phong,"));
    CHECK_THROWS_WITH(set("shadow", "true"), Contains("unknown feature \"shadow\", expected one of shading, "));
    CHECK_FALSE(features.enableShading);
    CHECK(features.numPixelSamples == 1);
}
