#pragma once
#include "files/feature_settings.h"
#include "files/scene_file.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

namespace files_test {

// Of one type without padding.
template <typename T> bool sameBits(const T& a, const T& b)
{
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

inline bool sameBits(const Scene::SceneLight& a, const Scene::SceneLight& b)
{
    const auto same = [&](const auto& light) {
        const auto* other = std::get_if<std::remove_cvref_t<decltype(light)>>(&b);
        return other != nullptr && sameBits(light, *other);
    };
    return std::visit(same, a);
}

inline bool sameBits(const std::shared_ptr<const Image>& a, const std::shared_ptr<const Image>& b)
{
    return a->width == b->width && a->height == b->height && a->channels == b->channels
        && a->pixels.size() == b->pixels.size()
        && std::memcmp(a->get_data(), b->get_data(), a->pixels.size() * static_cast<std::size_t>(a->channels)) == 0;
}

template <typename T> bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
    return std::ranges::equal(a, b, [](const T& x, const T& y) { return sameBits(x, y); });
}

inline std::size_t textureIndex(const Scene& scene, const Image* texture)
{
    const auto is = [&](const auto& owned) { return owned.get() == texture; };
    return static_cast<std::size_t>(std::ranges::find_if(scene.textures, is) - scene.textures.begin());
}

inline void checkSameMaterial(const Scene& sceneA, Material a, const Scene& sceneB, Material b)
{
    CHECK(textureIndex(sceneA, a.kdTexture) == textureIndex(sceneB, b.kdTexture));
    a.kdTexture = b.kdTexture = nullptr;
    CHECK(sameBits(a, b));
}

inline void checkSameScene(const Scene& a, const Scene& b)
{
    CHECK(sameBits(a.textures, b.textures));
    REQUIRE(a.meshes.size() == b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        CHECK(sameBits(a.meshes[i].vertices, b.meshes[i].vertices));
        CHECK(sameBits(a.meshes[i].triangles, b.meshes[i].triangles));
        checkSameMaterial(a, a.meshes[i].material, b, b.meshes[i].material);
    }
    REQUIRE(a.spheres.size() == b.spheres.size());
    for (std::size_t i = 0; i < a.spheres.size(); ++i) {
        CHECK(sameBits(a.spheres[i].center, b.spheres[i].center));
        CHECK(sameBits(a.spheres[i].radius, b.spheres[i].radius));
        checkSameMaterial(a, a.spheres[i].material, b, b.spheres[i].material);
    }
}

inline void checkSameConfig(const Config& a, const Config& b)
{
    CHECK(a.size == b.size);
    CHECK(sameBits(a.camera, b.camera));
    for (const std::string& name : files::featureNames()) {
        INFO(name);
        CHECK(files::featureValue(a.features, name) == files::featureValue(b.features, name));
    }
}

}
