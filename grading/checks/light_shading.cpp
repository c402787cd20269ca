#include "grading/checks/light_shading.h"
#include "grading/expect.h"
#include "grading/oracle/random_scene.h"
#include <fmt/format.h>

namespace grading {
namespace {

    glm::dvec3 toLight(const Stage& stage, const glm::dvec3& position)
    {
        return glm::normalize(position - stage.shaded.point());
    }

    // What Phong or Blinn and Phong add.
    glm::dvec3 highlight(const Stage& stage, const PointLight& light)
    {
        const glm::dvec3 normal { stage.shaded.hitInfo.normal };
        const glm::dvec3 direction = toLight(stage, glm::dvec3(light.position));
        const glm::dvec3 toCamera = glm::normalize(-glm::dvec3(stage.shaded.ray.direction));
        const double cosine = stage.features.shadingModel == ShadingModel::Phong
            ? glm::dot(2.0 * glm::dot(normal, direction) * normal - direction, toCamera)
            : glm::dot(normal, glm::normalize(direction + toCamera));
        const Material& material = stage.shaded.hitInfo.material;
        const double lobe = std::pow(std::max(cosine, 0.0), static_cast<double>(material.shininess));
        return glm::dvec3(light.color) * glm::dvec3(material.ks) * lobe;
    }

    const Features shadows { .enableShading = true, .enableShadows = true, .enableAccelStructure = true };

    // How the light itself is shaded has checks of its own.
    void compareToOpen(Exam& exam, const LightKind& kind, const Features& features, float alpha,
        const glm::dvec3& expectedOfOne, const std::string& what)
    {
        // Two samples of a light that is 1e-4 large, 1 or more away.
        constexpr double tolerance = 5e-4;
        for (int i = 0; i < 30; ++i) {
            Stage stage = randomStage(exam.random);
            stage.features = features;
            const PointLight light = randomLight(exam.random, stage);
            const glm::vec3 open = contribution(exam, stage, kind.make(light));
            Material material = randomMaterial(exam.random);
            material.kd = glm::vec3(0.9f, 0.6f, 0.3f);
            material.transparency = alpha;
            addPane(stage, exam.random, light.position, 0.5, material);
            const bool isLit = open.x > 0.0f && open.y > 0.0f && open.z > 0.0f;
            expect(isLit, kind.asked(stage, light, "nothing in between"), toText(open), "light");
            expectNear(kind.asked(stage, light, what), contribution(exam, stage, kind.make(light)),
                glm::dvec3(open) * expectedOfOne, tolerance);
        }
    }

}

glm::dvec3 lambert(const Stage& stage, const glm::dvec3& position, const glm::dvec3& color)
{
    const auto& hit = stage.shaded.hitInfo;
    const double cosine = glm::dot(glm::dvec3(hit.normal), toLight(stage, position));
    return color * glm::dvec3(hit.material.kd) * std::max(cosine, 0.0);
}

glm::dvec3 shadingOf(const Stage& stage, const PointLight& light)
{
    const glm::dvec3 diffuse = lambert(stage, glm::dvec3(light.position), glm::dvec3(light.color));
    return stage.features.shadingModel == ShadingModel::Lambertian ? diffuse : diffuse + highlight(stage, light);
}

std::vector<glm::vec3> contributions(
    Exam& exam, Stage stage, const Scene::SceneLight& light, uint32_t numSamples, const std::vector<uint32_t>& seeds)
{
    stage.scene.lights = { light };
    auto colors = exam.ask<std::vector<glm::vec3>>("light.contribution", stage, numSamples, seeds);
    expectCount("contributions of lights", colors.size(), seeds.size());
    return colors;
}

glm::vec3 contribution(Exam& exam, const Stage& stage, const Scene::SceneLight& light, uint32_t numSamples)
{
    return contributions(exam, stage, light, numSamples, { exam.random.seed() })[0];
}

PointLight randomLight(Random& random, const Stage& stage)
{
    const glm::vec3 position = lightPosition(random, stage, random.uniform(1.0f, 3.0f));
    return { position, random.color() };
}

Stage shinyStage(Random& random, ShadingModel model, PointLight& light)
{
    Stage stage = randomStage(random);
    stage.features.shadingModel = model;
    const glm::vec3 mirrored = glm::reflect(stage.shaded.ray.direction, stage.shaded.hitInfo.normal);
    const glm::vec3 direction = glm::normalize(mirrored + 0.2f * random.direction());
    light = { glm::vec3(stage.shaded.point()) + 2.0f * direction, random.color() };
    return stage;
}

std::string LightKind::asked(const Stage& stage, const PointLight& light, const std::string& what) const
{
    return fmt::format("{} {} of colour {}, normal {}, kd {}, {}", function, describe(stage, light.position),
        toText(light.color), toText(stage.shaded.hitInfo.normal), toText(stage.shaded.hitInfo.material.kd), what);
}

void expectBlocked(Exam& exam, const LightKind& kind)
{
    compareToOpen(exam, kind, shadows, 1.0f, glm::dvec3(0.0), "a triangle in between");
}

void expectThroughPane(Exam& exam, const LightKind& kind)
{
    Features features = shadows;
    features.enableTransparency = true;
    compareToOpen(exam, kind, features, 0.5f, { 0.45, 0.3, 0.15 },
        "a pane with kd (0.9, 0.6, 0.3) and transparency 0.5 in between");
}

void expectNoShadow(Exam& exam, const LightKind& kind)
{
    compareToOpen(exam, kind, { .enableShading = true, .enableAccelStructure = true }, 1.0f, glm::dvec3(1.0),
        "a triangle in between, shadows off");
}

}
