#include "grading/check.h"
#include "grading/checks/light_shading.h"
#include "grading/expect.h"

// The shading of what arrives from a point light.
namespace grading::light_contribution {
namespace {

    const LightKind point { "computeContributionPointLight",
        [](const PointLight& light) -> Scene::SceneLight { return light; } };

    const Check shading("light.point.shading", 1.0,
        "computeShading gets the direction from ray.origin + ray.t * ray.direction to the light, of length 1, and the "
        "light's colour once, which may be above 1",
        [](Exam& exam) {
            for (int i = 0; i < 60; ++i) {
                Stage stage = randomStage(exam.random);
                PointLight light = randomLight(exam.random, stage);
                const float brightness = i % 2 == 0 ? 1.0f : 4.0f;
                light.color *= brightness;
                if (i % 3 == 0)
                    stretch(stage, exam.random);
                expectNear(point.asked(stage, light, "nothing in between"), contribution(exam, stage, light),
                    shadingOf(stage, light), static_cast<double>(brightness) * offsetTolerance);
            }
        });

    const Check view("light.point.view", 1.0,
        "computeShading gets the direction from the point to the camera, -ray.direction, with the light's direction "
        "second",
        [](Exam& exam) {
            for (const ShadingModel model : { ShadingModel::Phong, ShadingModel::BlinnPhong }) {
                for (int i = 0; i < 30; ++i) {
                    PointLight light {};
                    const Stage stage = shinyStage(exam.random, model, light);
                    expectNear(point.asked(stage, light, "a shiny material"), contribution(exam, stage, light),
                        shadingOf(stage, light), 2.0 * offsetTolerance);
                }
            }
        });

    const Check blocked("light.point.blocked", 0.5,
        "a light that is not visible contributes nothing: ask visibilityOfLightSample",
        [](Exam& exam) { expectBlocked(exam, point); });
    const Check off("light.point.shadows_off", 0.5, "with shadows off every light is visible",
        [](Exam& exam) { expectNoShadow(exam, point); });
    const Check pane("light.point.pane", 0.5,
        "the colour that visibilityOfLightSample returns is what is shaded, in place of the light's own",
        [](Exam& exam) { expectThroughPane(exam, point); });

}
}
