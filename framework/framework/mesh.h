#pragma once
#include "image.h"
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 texCoord;

    [[nodiscard]] constexpr bool operator==(const Vertex&) const noexcept = default;
};

struct Material {
    glm::vec3 kd { 0.0f }; // diffuse reflectance
    glm::vec3 ks { 0.0f }; // specular reflectance, of mirrors too
    float shininess = 1.0f;
    float transparency = 1.0f; // alpha: 1 is opaque, 0 lets everything through
    const Image* kdTexture = nullptr; // replaces kd; the scene owns it
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<glm::uvec3> triangles; // indices into vertices
    Material material;
};
