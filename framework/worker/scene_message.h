#pragma once
#include "scene.h"
#include "worker/message.h"

// Scenes and what they own, for another process. A texture travels with the scene that owns it; a material on its own
// travels without one, and comes back with a pointer that means nothing here.
namespace worker {

inline Message& operator<<(Message& message, const Image& image)
{
    message << image.width << image.height << image.channels;
    message.append(image.get_data(), image.pixels.size() * static_cast<std::size_t>(image.channels));
    return message;
}

inline Reader& operator>>(Reader& reader, Image& image)
{
    const auto width = reader.read<int>();
    const auto height = reader.read<int>();
    image = Image(width, height, reader.read<int>());
    const auto bytes = reader.take(image.pixels.size() * static_cast<std::size_t>(image.channels));
    std::memcpy(image.get_data(), bytes.data(), bytes.size());
    return reader;
}

inline Message& operator<<(Message& message, const Mesh& mesh)
{
    return message << mesh.vertices << mesh.triangles << mesh.material;
}

inline Reader& operator>>(Reader& reader, Mesh& mesh)
{
    return reader >> mesh.vertices >> mesh.triangles >> mesh.material;
}

inline Message& operator<<(Message& message, const Scene& scene)
{
    message << scene.meshes << scene.spheres << scene.lights << scene.textures.size();
    for (const auto& texture : scene.textures) {
        message << *texture;
        for (const Mesh& mesh : scene.meshes)
            message << (mesh.material.kdTexture == texture.get());
    }
    return message;
}

inline Reader& operator>>(Reader& reader, Scene& scene)
{
    reader >> scene.meshes >> scene.spheres >> scene.lights;
    for (Mesh& mesh : scene.meshes)
        mesh.material.kdTexture = nullptr;
    for (auto left = reader.read<std::size_t>(); left > 0; --left) {
        const auto texture = std::make_shared<const Image>(reader.read<Image>());
        scene.textures.push_back(texture);
        for (Mesh& mesh : scene.meshes)
            if (reader.read<bool>())
                mesh.material.kdTexture = texture.get();
    }
    return reader;
}

}
