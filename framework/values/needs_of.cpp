#include "values/needs_of.h"
#include "provided/marks.h"
#include <algorithm>

namespace values {
namespace {

    // What a rule looks at.
    struct Subject {
        const Scene& scene;
        const Features& features;

        template <typename Predicate> [[nodiscard]] bool anyMaterial(const Predicate& predicate) const
        {
            const auto hasIt = [&](const auto& thing) { return predicate(thing.material); };
            return std::ranges::any_of(scene.meshes, hasIt) || std::ranges::any_of(scene.spheres, hasIt);
        }

        template <typename Light> [[nodiscard]] bool anyLight() const
        {
            return std::ranges::any_of(
                scene.lights, [](const Scene::SceneLight& light) { return std::holds_alternative<Light>(light); });
        }

        [[nodiscard]] bool letsLightThrough() const
        {
            return anyMaterial([](const Material& material) { return material.transparency != 1.0f; });
        }
    };

    // Why a picture does not need something; empty if it does.
    std::string whyNoTriangles(const Subject& s)
    {
        const auto hasSome = [](const Mesh& mesh) { return !mesh.triangles.empty(); };
        return std::ranges::any_of(s.scene.meshes, hasSome) ? "" : "the scene has none";
    }

    std::string whyNoSpheres(const Subject& s)
    {
        return s.scene.spheres.empty() ? "the scene has none" : "";
    }

    std::string whyNoTextures(const Subject& s)
    {
        if (provided::hasOwnColors())
            return "";
        if (!s.features.enableTextureMapping)
            return "texture_mapping is off";
        return s.anyMaterial([](const Material& m) { return m.kdTexture != nullptr; }) ? "" : "no material has one";
    }

    std::string whyNoShadingNormals(const Subject& s)
    {
        if (!s.features.enableNormalInterp)
            return "normal_interp is off";
        const auto hasSome = [](const Mesh& mesh) {
            return std::ranges::any_of(mesh.vertices, [](const Vertex& v) { return v.normal != glm::vec3(0.0f); });
        };
        return std::ranges::any_of(s.scene.meshes, hasSome) ? "" : "no corner of a mesh has one";
    }

    std::string whyNoMirrors(const Subject& s)
    {
        if (!s.features.enableReflections)
            return "reflections are off";
        return s.anyMaterial([](const Material& m) { return m.ks != glm::vec3(0.0f); }) ? ""
                                                                                        : "every material has ks = 0";
    }

    std::string whyNoTransparency(const Subject& s)
    {
        if (!s.features.enableTransparency)
            return "transparency is off";
        return s.letsLightThrough() ? "" : "every material is opaque";
    }

    std::string whyNoPointLights(const Subject& s)
    {
        return s.anyLight<PointLight>() ? "" : "the scene has none";
    }

    std::string whyNoAreaLights(const Subject& s)
    {
        return s.anyLight<SegmentLight>() || s.anyLight<ParallelogramLight>() ? "" : "the scene has none";
    }

    std::string whyNoEnvironment(const Subject& s)
    {
        return s.features.extra.enableEnvironmentMap ? "" : "environment_map is off";
    }

    std::string whyNoPixelRays(const Subject& s)
    {
        const bool isOne = s.features.numPixelSamples <= 1 && !s.features.extra.enableOwenSampling;
        return isOne && !provided::hasOwnPixels() ? "one goes through the centre" : "";
    }

    std::string whyNoShadows(const Subject& s)
    {
        if (!s.features.enableShadows)
            return "shadows are off";
        return s.scene.lights.empty() ? "the scene has no light" : "";
    }

    std::string whyNoShadowsInOrder(const Subject& s)
    {
        const std::string why = whyNoShadows(s);
        return why.empty() ? whyNoTransparency(s) : why;
    }

    // What surfaces show of light from below, or black: with shading off the colour of the light, by a gradient any.
    std::string whyNoLightFromBehind(const Subject& s)
    {
        const bool isOwn = provided::hasOwnModels() || provided::hasOwnColors();
        const bool isShown = !s.features.enableShading || isByGradient(s.features.shadingModel) || isOwn;
        return isShown ? "" : "the model of shading gives black for it";
    }

}

std::vector<Need> judgeNeeds(const Scene& scene, const Features& features)
{
    struct Rule {
        const char* part;
        bool SceneNeeds::*member;
        std::string (*why)(const Subject&);
    };
    constexpr Rule rules[] {
        { "triangles", &SceneNeeds::triangles, whyNoTriangles },
        { "spheres", &SceneNeeds::spheres, whyNoSpheres },
        { "textures", &SceneNeeds::textures, whyNoTextures },
        { "shading normals", &SceneNeeds::shadingNormals, whyNoShadingNormals },
        { "mirrors", &SceneNeeds::mirrors, whyNoMirrors },
        { "transparency", &SceneNeeds::transparency, whyNoTransparency },
        { "point lights", &SceneNeeds::pointLights, whyNoPointLights },
        { "area lights", &SceneNeeds::areaLights, whyNoAreaLights },
        { "environment", &SceneNeeds::environment, whyNoEnvironment },
        { "rays of a pixel", &SceneNeeds::pixelRays, whyNoPixelRays },
        { "shadows", &SceneNeeds::shadows, whyNoShadows },
        { "order of what throws a shadow", &SceneNeeds::shadowsInOrder, whyNoShadowsInOrder },
        { "light from behind", &SceneNeeds::lightFromBehind, whyNoLightFromBehind },
    };
    std::vector<Need> needs;
    for (const auto& [part, member, why] : rules) {
        std::string reason = why({ scene, features });
        needs.push_back({ part, member, reason.empty(), std::move(reason) });
    }
    return needs;
}

SceneNeeds needsOf(const Scene& scene, const Features& features)
{
    SceneNeeds needs;
    if (features.extra.enableSkipping)
        for (const Need& need : judgeNeeds(scene, features))
            needs.*need.member = need.isNeeded;
    return needs;
}

}
