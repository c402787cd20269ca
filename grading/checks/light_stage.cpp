#include "grading/checks/light_stage.h"
#include "grading/expect.h"
#include "grading/oracle/random_scene.h"
#include <fmt/format.h>

namespace grading {
namespace {

    glm::dvec3 across(const glm::dvec3& direction)
    {
        const glm::dvec3 other = std::abs(direction.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        return glm::normalize(glm::cross(direction, other));
    }

    // At an angle to the normal whose cosine is minCosine or more.
    glm::vec3 directionAbove(Random& random, const glm::vec3& normal, float minCosine)
    {
        const glm::vec3 tangent = glm::normalize(glm::cross(normal, random.direction()));
        const float cosine = random.uniform(minCosine, 1.0f);
        return glm::normalize(cosine * normal + std::sqrt(1.0f - cosine * cosine) * tangent);
    }

}

Stage randomStage(Random& random)
{
    Stage stage;
    stage.features = { .enableShading = true, .enableShadows = true, .enableAccelStructure = true };
    const glm::vec3 normal = random.direction();
    const glm::vec3 direction = -directionAbove(random, normal, 0.3f);
    const float t = random.uniform(1.0f, 4.0f);
    stage.shaded.ray = { random.vec3(-1.0f, 1.0f) - t * direction, direction, t };
    stage.shaded.hitInfo = { normal, glm::vec3(1.0f / 3.0f), random.vec2(), randomMaterial(random) };
    return stage;
}

void stretch(Stage& stage, Random& random)
{
    const float length = (random.integer(0, 1) == 0 ? 4.0f : 0.25f) * random.uniform(0.8f, 1.2f);
    stage.shaded.ray.direction *= length;
    stage.shaded.ray.t /= length;
}

void addSurface(Stage& stage, Random& random, bool isSphere)
{
    const auto& [normal, barycentric, texCoord, material] = stage.shaded.hitInfo;
    if (isSphere) {
        const float radius = random.uniform(0.4f, 1.0f);
        const glm::dvec3 center = stage.shaded.point() - static_cast<double>(radius) * glm::dvec3(normal);
        stage.scene.spheres.push_back({ glm::vec3(center), radius, material });
        return;
    }
    const glm::dvec3 aside = static_cast<double>(random.uniform(0.0f, 0.8f)) * across(glm::dvec3(normal));
    addTriangleAround(stage.scene, stage.shaded.point() + aside, normal, 2.0f, material);
}

glm::vec3 lightPosition(Random& random, const Stage& stage, float distance, float minCosine)
{
    const glm::vec3 toLight = directionAbove(random, stage.shaded.hitInfo.normal, minCosine);
    return glm::vec3(stage.shaded.point()) + distance * toLight;
}

void addPane(Stage& stage, Random& random, const glm::vec3& light, double fraction, const Material& material)
{
    const glm::dvec3 toLight = glm::dvec3(light) - stage.shaded.point();
    const auto distance = static_cast<float>(glm::length(toLight));
    const glm::vec3 tilted = glm::normalize(glm::normalize(glm::vec3(toLight)) + 0.5f * random.direction());
    const float radius = random.uniform(0.1f, 0.3f) * distance;
    addTriangleAround(stage.scene, stage.shaded.point() + fraction * toLight, tilted, radius, material);
}

void addTriangleAround(
    Scene& scene, const glm::dvec3& center, const glm::vec3& normal, float radius, const Material& material)
{
    const glm::dvec3 u = across(glm::dvec3(normal));
    const glm::dvec3 v = glm::cross(glm::dvec3(normal), u);
    std::array<Vertex, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const double angle = 2.0944 * static_cast<double>(i);
        const glm::dvec3 offset = static_cast<double>(radius) * (std::cos(angle) * u + std::sin(angle) * v);
        corners[i] = { glm::vec3(center + offset), normal, {} };
    }
    addTriangle(scene.meshes.emplace_back(Mesh { {}, {}, material }), corners);
}

Material glass(Random& random, float alpha)
{
    Material material = randomMaterial(random);
    material.transparency = alpha;
    return material;
}

float smallGap(Random& random)
{
    return random.uniform(0.004f, 0.008f);
}

std::string describe(const Stage& stage, const glm::vec3& light)
{
    const double distance = glm::distance(glm::dvec3(light), stage.shaded.point());
    return fmt::format(
        "at {}, light {:.3g} away at {}", toText(glm::vec3(stage.shaded.point())), distance, toText(light));
}

}
