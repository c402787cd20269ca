#pragma once
#include "scene.h"
#include <filesystem>
#include <map>

namespace files {

// Opens pictures for a scene, each file once however often it is named; their texels are read when they are looked at.
class Textures {
public:
    explicit Textures(Scene& scene)
        : m_scene(scene)
    {
    }

    // The picture as the scene owns it. Throws Error.
    [[nodiscard]] const Image* load(const std::filesystem::path& path);

private:
    Scene& m_scene;
    std::map<std::filesystem::path, const Image*> m_loaded;
};

}
