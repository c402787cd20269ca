#include "grading/check.h"
#include "grading/checks/light_stage.h"
#include "grading/expect.h"
#include "grading/oracle/random_scene.h"
#include <fmt/format.h>

// Whether a light is visible from a shaded point.
namespace grading::light_visibility {
namespace {

    void expectVisibility(
        Exam& exam, const Stage& stage, const glm::vec3& light, bool expected, const std::string& what)
    {
        const auto came = exam.ask<uint8_t>("light.binary", stage, LightSample { light, exam.random.color() });
        const auto inWords = [](bool isVisible) { return isVisible ? "visible" : "not visible"; };
        expect((came != 0) == expected,
            fmt::format("visibilityOfLightSampleBinary {}, {}", describe(stage, light), what), inWords(came != 0),
            inWords(expected));
    }

    // From a tenth of the scene's size to fifty times.
    float anyDistance(Random& random)
    {
        return std::pow(10.0f, random.uniform(-1.0f, 1.7f));
    }

    // Half of them of glass, which blocks a light as well where it is either visible or not.
    void addBlocker(Stage& stage, Random& random, const glm::vec3& light)
    {
        const auto fraction = static_cast<double>(random.uniform(0.3f, 0.8f));
        addPane(stage, random, light, fraction, glass(random, random.integer(0, 1) == 0 ? 1.0f : 0.4f));
    }

    void addBlockingSphere(Stage& stage, Random& random, const glm::vec3& light)
    {
        const float fraction = random.uniform(0.4f, 0.6f);
        const glm::vec3 point { stage.shaded.point() };
        const float radius = random.uniform(0.1f, 0.3f) * glm::distance(point, light);
        stage.scene.spheres.push_back({ glm::mix(point, light, fraction), radius, randomMaterial(random) });
    }

    const Check blocked("light.binary.blocked", 1.0,
        "a shadow ray starts at ray.origin + ray.t * ray.direction and goes all the way to the light's position; "
        "whatever "
        "it meets blocks the light, glass too",
        [](Exam& exam) {
            for (int i = 0; i < 60; ++i) {
                Stage stage = randomStage(exam.random);
                const glm::vec3 light = lightPosition(exam.random, stage, anyDistance(exam.random));
                expectVisibility(exam, stage, light, true, "nothing in between");
                if (i % 2 == 0)
                    addBlocker(stage, exam.random, light);
                else
                    addBlockingSphere(stage, exam.random, light);
                expectVisibility(
                    exam, stage, light, false, i % 2 == 0 ? "a triangle in between" : "a sphere in between");
            }
        });

    const Check behind("light.binary.behind", 1.0,
        "what lies behind the light throws no shadow: the shadow ray's t is the distance to the light, in units of its "
        "direction",
        [](Exam& exam) {
            for (int i = 0; i < 90; ++i) {
                Stage stage = randomStage(exam.random);
                const bool isClose = i % 3 == 0; // as the ceiling that a lamp hangs from
                const float distance = isClose ? exam.random.uniform(0.5f, 2.0f) : anyDistance(exam.random);
                const glm::vec3 light = lightPosition(exam.random, stage, distance);
                const float gap
                    = isClose ? smallGap(exam.random) : std::max(0.01f, exam.random.uniform(0.05f, 1.0f) * distance);
                addPane(
                    stage, exam.random, light, 1.0 + static_cast<double>(gap / distance), randomMaterial(exam.random));
                expectVisibility(exam, stage, light, true, fmt::format("a triangle {:.3g} behind the light", gap));
                addBlocker(stage, exam.random, light);
                expectVisibility(exam, stage, light, false, "a triangle behind the light, and one in between");
            }
        });

    const Check self("light.binary.self", 1.0,
        "by rounding a shadow ray may start below the surface and hit it: start it 1e-5 to 1e-3 away, along the normal",
        [](Exam& exam) {
            constexpr float grazing = 0.15f; // cosine
            for (int i = 0; i < 300; ++i) {
                Stage stage = randomStage(exam.random);
                addSurface(stage, exam.random, i % 2 == 0);
                const glm::vec3 light = lightPosition(exam.random, stage, exam.random.uniform(0.5f, 3.0f), grazing);
                expectVisibility(exam, stage, light, true, "nothing but the surface itself around");
            }
        });

    const Check close("light.binary.close", 0.5,
        "a shadow ray that starts 1e-2 away from the surface, or ends so far before the light, jumps over what stands "
        "close to it: 1e-3 is enough",
        [](Exam& exam) {
            for (int i = 0; i < 60; ++i) {
                const Stage open = randomStage(exam.random);
                const float distance = exam.random.uniform(1.0f, 3.0f);
                const glm::vec3 light = lightPosition(exam.random, open, distance, 0.5f);
                const float gap = smallGap(exam.random);
                const glm::vec3 normal = open.shaded.hitInfo.normal;

                Stage stage = open;
                const glm::dvec3 above = open.shaded.point() + glm::dvec3(gap * normal);
                addTriangleAround(stage.scene, above, normal, 0.3f, randomMaterial(exam.random));
                expectVisibility(exam, stage, light, false, fmt::format("a triangle {:.2g} above the surface", gap));

                stage = open;
                addPane(
                    stage, exam.random, light, 1.0 - static_cast<double>(gap / distance), randomMaterial(exam.random));
                expectVisibility(exam, stage, light, false, fmt::format("a triangle {:.2g} before the light", gap));
            }
        });

    const Check lengths("light.binary.lengths", 0.5,
        "the point is ray.origin + ray.t * ray.direction, whatever the direction's length: do not normalise it",
        [](Exam& exam) {
            for (int i = 0; i < 40; ++i) {
                Stage stage = randomStage(exam.random);
                stretch(stage, exam.random);
                const float length = glm::length(stage.shaded.ray.direction);
                const glm::vec3 light = lightPosition(exam.random, stage, exam.random.uniform(0.5f, 3.0f));
                const std::string along = fmt::format("the view ray's direction {:.2g} long", length);
                expectVisibility(exam, stage, light, true, along + ", nothing in between");
                addBlocker(stage, exam.random, light);
                expectVisibility(exam, stage, light, false, along + ", a triangle in between");
            }
        });

}
}
