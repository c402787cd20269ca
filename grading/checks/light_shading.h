#pragma once
#include "grading/checks/light_stage.h"
#include <string>
#include <vector>

// What lights contribute, by the submission and by the models in double precision.
namespace grading {

// The direction to the light may be taken from where the shadow ray starts, up to 1e-3 beside the point.
inline constexpr double offsetTolerance = 5e-3;

// The diffuse part of what comes from one point of a light.
[[nodiscard]] glm::dvec3 lambert(const Stage& stage, const glm::dvec3& position, const glm::dvec3& color);

// What comes from a light that is visible, by the stage's shading model: Lambert's, Phong's or Blinn and Phong's.
[[nodiscard]] glm::dvec3 shadingOf(const Stage& stage, const PointLight& light);

// What the submission says of the light as the only one; one value for each seed.
[[nodiscard]] std::vector<glm::vec3> contributions(
    Exam& exam, Stage stage, const Scene::SceneLight& light, uint32_t numSamples, const std::vector<uint32_t>& seeds);
[[nodiscard]] glm::vec3 contribution(
    Exam& exam, const Stage& stage, const Scene::SceneLight& light, uint32_t numSamples = 1);

// Above the surface, 1 to 3 away; no channel of its colour above 1.
[[nodiscard]] PointLight randomLight(Random& random, const Stage& stage);

// A stage with a shiny material and a light near the direction in which it mirrors the view ray.
[[nodiscard]] Stage shinyStage(Random& random, ShadingModel model, PointLight& light);

// A kind of light: what it is called, and one of it that is as small as a point.
struct LightKind {
    std::string function;
    Scene::SceneLight (*make)(const PointLight& light);

    [[nodiscard]] std::string asked(const Stage& stage, const PointLight& light, const std::string& what) const;
};

// Compares the light with nothing in between to the same light behind something opaque, and behind a pane, and behind
// something opaque with shadows off.
void expectBlocked(Exam& exam, const LightKind& kind);
void expectThroughPane(Exam& exam, const LightKind& kind);
void expectNoShadow(Exam& exam, const LightKind& kind);

}
