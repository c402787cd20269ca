#include "files/feature_settings.h"
#include <array>
#include <charconv>
#include <framework/variant_helper.h>
#include <stdexcept>

namespace files {
namespace {

    constexpr CountRange samples { 1, 1 << 20 };

    using Member = std::variant<bool Features::*, uint32_t Features::*, ShadingModel Features::*, bool ExtraFeatures::*,
        uint32_t ExtraFeatures::*>;

    struct Setting {
        std::string_view name;
        Member member;
        CountRange range = samples; // of a count
    };

    constexpr auto settings = std::to_array<Setting>({
        { "shading", &Features::enableShading },
        { "reflections", &Features::enableReflections },
        { "shadows", &Features::enableShadows },
        { "normal_interp", &Features::enableNormalInterp },
        { "texture_mapping", &Features::enableTextureMapping },
        { "accel_structure", &Features::enableAccelStructure },
        { "bilinear_filtering", &Features::enableBilinearTextureFiltering },
        { "transparency", &Features::enableTransparency },
        { "jittered_sampling", &Features::enableJitteredSampling },
        { "debug_draw", &Features::enableDebugDraw },
        { "shading_model", &Features::shadingModel },
        { "pixel_samples", &Features::numPixelSamples },
        { "shadow_samples", &Features::numShadowSamples },
        { "bvh_sah_binning", &ExtraFeatures::enableBvhSahBinning },
        { "bloom", &ExtraFeatures::enableBloomEffect },
        { "depth_of_field", &ExtraFeatures::enableDepthOfField },
        { "environment_map", &ExtraFeatures::enableEnvironmentMap },
        { "glossy_reflection", &ExtraFeatures::enableGlossyReflection },
        { "mipmap_filtering", &ExtraFeatures::enableMipmapTextureFiltering },
        { "motion_blur", &ExtraFeatures::enableMotionBlur },
        { "skipping", &ExtraFeatures::enableSkipping },
        { "owen_sampling", &ExtraFeatures::enableOwenSampling },
        { "glossy_samples", &ExtraFeatures::numGlossySamples },
        { "max_depth", &ExtraFeatures::maxDepth, { 0, 6 } },
        { "proposed_shadow_formula", &ExtraFeatures::enableProposedShadowFormula },
    });

    constexpr std::array<std::string_view, 5> shadingModels { // in the order of ShadingModel
        "lambertian", "phong", "blinn_phong", "linear_gradient", "linear_gradient_comparison"
    };

    template <typename Names> std::string listed(const Names& names)
    {
        std::string list;
        for (const auto& name : names)
            list.append(list.empty() ? "" : ", ").append(name);
        return list;
    }

    std::string shown(const FeatureValue& value)
    {
        return std::visit(
            make_visitor([](bool b) { return std::string(b ? "true" : "false"); },
                [](int64_t i) { return std::to_string(i); }, [](const std::string& s) { return '"' + s + '"'; }),
            value);
    }

    [[noreturn]] void refuse(const Setting& setting, const FeatureValue& value, const std::string& expected)
    {
        throw std::invalid_argument(std::string(setting.name) + ": found " + shown(value) + ", expected " + expected);
    }

    void assign(bool& target, const Setting& setting, const FeatureValue& value)
    {
        const bool* found = std::get_if<bool>(&value);
        if (found == nullptr)
            refuse(setting, value, "true or false");
        target = *found;
    }

    void assign(uint32_t& target, const Setting& setting, const FeatureValue& value)
    {
        const auto [least, most] = setting.range;
        const int64_t* found = std::get_if<int64_t>(&value);
        if (found == nullptr || *found < least || *found > most)
            refuse(setting, value, "a count from " + std::to_string(least) + " to " + std::to_string(most));
        target = static_cast<uint32_t>(*found);
    }

    void assign(ShadingModel& target, const Setting& setting, const FeatureValue& value)
    {
        const std::string* found = std::get_if<std::string>(&value);
        const auto model = found ? std::ranges::find(shadingModels, *found) : shadingModels.end();
        if (model == shadingModels.end())
            refuse(setting, value, "one of " + listed(shadingModels));
        target = static_cast<ShadingModel>(model - shadingModels.begin());
    }

    FeatureValue valueOf(bool source)
    {
        return source;
    }
    FeatureValue valueOf(uint32_t source)
    {
        return int64_t { source };
    }
    FeatureValue valueOf(ShadingModel source)
    {
        return std::string(shadingModels.at(static_cast<std::size_t>(source)));
    }

    // As a scene file would read it, with no quotes around strings.
    FeatureValue parse(std::string_view text)
    {
        if (text == "true" || text == "false")
            return text == "true";
        int64_t number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error == std::errc {} && end == text.data() + text.size())
            return number;
        return std::string(text);
    }

}

std::vector<std::string> featureNames()
{
    std::vector<std::string> names;
    for (const Setting& setting : settings)
        names.emplace_back(setting.name);
    return names;
}

std::vector<std::string> shadingModelNames()
{
    return { shadingModels.begin(), shadingModels.end() };
}

CountRange countRange(std::string_view name)
{
    return std::ranges::find(settings, name, &Setting::name)->range;
}

FeatureValue featureValue(const Features& features, std::string_view name)
{
    const auto setting = std::ranges::find(settings, name, &Setting::name);
    const auto get = make_visitor([&](auto Features::*member) { return valueOf(features.*member); },
        [&](auto ExtraFeatures::*member) { return valueOf(features.extra.*member); });
    return std::visit(get, setting->member);
}

void setFeatureValue(Features& features, std::string_view name, const FeatureValue& value)
{
    const auto setting = std::ranges::find(settings, name, &Setting::name);
    if (setting == settings.end())
        throw std::invalid_argument(
            "found the unknown feature \"" + std::string(name) + "\", expected one of " + listed(featureNames()));
    const auto set = make_visitor([&](auto Features::*member) { assign(features.*member, *setting, value); },
        [&](auto ExtraFeatures::*member) { assign(features.extra.*member, *setting, value); });
    std::visit(set, setting->member);
}

void setFeature(Features& features, std::string_view name, std::string_view value)
{
    setFeatureValue(features, name, parse(value));
}

}
