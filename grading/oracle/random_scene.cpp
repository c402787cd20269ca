#include "grading/oracle/random_scene.h"

namespace grading {
namespace {

    constexpr std::size_t meshSize = 25; // triangles
    constexpr float minHeight = 0.1f; // of a triangle that is no sliver

    bool isSliver(const std::array<glm::vec3, 3>& corners)
    {
        const auto& [a, b, c] = corners;
        const float longest = std::max({ glm::distance(a, b), glm::distance(b, c), glm::distance(c, a) });
        return glm::length(glm::cross(b - a, c - a)) < minHeight * longest;
    }

    std::array<glm::vec3, 3> randomCorners(Random& random, const glm::vec3& center)
    {
        for (;;) {
            const glm::vec3 middle = center + random.vec3(-1.0f, 1.0f);
            std::array<glm::vec3, 3> corners;
            for (glm::vec3& corner : corners)
                corner = middle + random.vec3(-0.3f, 0.3f);
            if (!isSliver(corners))
                return corners;
        }
    }

}

Material randomMaterial(Random& random)
{
    const glm::vec3 kd = random.color();
    return { .kd = kd, .ks = random.color(), .shininess = random.uniform(2.0f, 20.0f) };
}

std::array<Vertex, 3> randomTriangle(Random& random, const glm::vec3& center)
{
    const auto corners = randomCorners(random, center);
    const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    std::array<Vertex, 3> vertices;
    for (std::size_t i = 0; i < 3; ++i)
        vertices[i] = { corners[i], glm::normalize(normal + 0.3f * random.direction()), random.vec2() };
    return vertices;
}

void addTriangle(Mesh& mesh, const std::array<Vertex, 3>& corners)
{
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back(first + glm::uvec3(0, 1, 2));
}

void addTriangles(Scene& scene, Random& random, int count, const glm::vec3& center)
{
    scene.meshes.push_back({ {}, {}, randomMaterial(random) });
    for (int i = 0; i < count; ++i) {
        if (scene.meshes.back().triangles.size() == meshSize)
            scene.meshes.push_back({ {}, {}, randomMaterial(random) });
        addTriangle(scene.meshes.back(), randomTriangle(random, center));
    }
}

void addSpheres(Scene& scene, Random& random, int count)
{
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = random.vec3(-1.0f, 1.0f);
        const float radius = random.uniform(0.1f, 0.4f);
        scene.spheres.push_back({ center, radius, randomMaterial(random) });
    }
}

}
