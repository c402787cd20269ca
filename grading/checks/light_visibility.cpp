#include "grading/check.h"
#include "grading/checks/light_stage.h"
#include "grading/expect.h"
#include "grading/oracle/random_scene.h"
#include <fmt/format.h>

// What is left of a light at a shaded point.
namespace grading {
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

    Material glass(Random& random, float alpha)
    {
        Material material = randomMaterial(random);
        material.transparency = alpha;
        return material;
    }

    // Half of them of glass: whatever lies in between, a light that is visible or not is not.
    void addBlocker(Stage& stage, Random& random, const glm::vec3& light)
    {
        const auto fraction = static_cast<double>(random.uniform(0.3f, 0.8f));
        addPane(stage, random, light, fraction, glass(random, random.integer(0, 1) == 0 ? 1.0f : 0.4f));
    }

    // Closer to a surface or a light than this nothing is asked: shadow rays may start and end up to 1e-3 beside them.
    float smallGap(Random& random)
    {
        return random.uniform(0.004f, 0.008f);
    }

    void addBlockingSphere(Stage& stage, Random& random, const glm::vec3& light)
    {
        const float fraction = random.uniform(0.4f, 0.6f);
        const glm::vec3 point { stage.shaded.point() };
        const float radius = random.uniform(0.1f, 0.3f) * glm::distance(point, light);
        stage.scene.spheres.push_back({ glm::mix(point, light, fraction), radius, randomMaterial(random) });
    }

    const Check blocked("light.binary.blocked", 1.0,
        "a shadow ray starts at ray.origin + ray.t * ray.direction and goes all the way to the light's position",
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

    glm::dvec3 passed(const Material& material)
    {
        return glm::dvec3(material.kd) * (1.0 - static_cast<double>(material.transparency));
    }

    void expectLight(
        Exam& exam, const Stage& stage, const LightSample& light, const glm::dvec3& factor, const std::string& what)
    {
        const auto came = exam.ask<glm::vec3>("light.transparency", stage, light);
        expectNear(fmt::format("visibilityOfLightSampleTransparency {} of colour {}, {}",
                       describe(stage, light.position), toText(light.color), what),
            came, glm::dvec3(light.color) * factor, fewRoundings);
    }

    Stage transparentStage(Random& random)
    {
        Stage stage = randomStage(random);
        stage.features.enableTransparency = true;
        stage.shaded.hitInfo.material = glass(random, 0.8f); // its own does not count
        return stage;
    }

    LightSample randomLight(Random& random, const Stage& stage)
    {
        return { lightPosition(random, stage, random.uniform(0.5f, 5.0f)), random.color() };
    }

    // Panes, the first of them closest to the shaded point; alpha for each.
    void expectThroughPanes(Exam& exam, Stage stage, const std::vector<float>& alphas, const std::string& what)
    {
        const LightSample light = randomLight(exam.random, stage);
        glm::dvec3 factor { 1.0 };
        for (std::size_t i = 0; i < alphas.size(); ++i) {
            const Material material = glass(exam.random, alphas[i]);
            const double fraction = (static_cast<double>(i) + 0.5) / static_cast<double>(alphas.size());
            addPane(stage, exam.random, light.position, fraction, material);
            factor *= passed(material);
        }
        expectLight(exam, stage, light, factor, what);
    }

    float someAlpha(Random& random) // not 0.5: alpha and 1 - alpha differ
    {
        const float alpha = random.uniform(0.1f, 0.4f);
        return random.integer(0, 1) == 0 ? alpha : 1.0f - alpha;
    }

    const Check clear("light.transparency.clear", 0.5,
        "where nothing is in between all of lightColor is left; the shaded surface itself is not in between",
        [](Exam& exam) {
            for (int i = 0; i < 200; ++i) {
                Stage stage = transparentStage(exam.random);
                addSurface(stage, exam.random, i % 2 == 0);
                expectLight(exam, stage, randomLight(exam.random, stage), glm::dvec3(1.0), "nothing in between");
            }
        });
    const Check pane("light.transparency.pane", 1.0,
        "a surface leaves light * kd * (1 - transparency), kd and transparency being its own: transparency 1 is opaque",
        [](Exam& exam) {
            for (int i = 0; i < 40; ++i)
                expectThroughPanes(
                    exam, transparentStage(exam.random), { someAlpha(exam.random) }, "a pane in between");
        });
    const Check panes("light.transparency.panes", 0.5,
        "behind the first surface the light may meet another one: go on until nothing is left in between",
        [](Exam& exam) {
            for (int i = 0; i < 40; ++i) {
                Stage stage = transparentStage(exam.random);
                if (i % 2 == 0)
                    stretch(stage, exam.random);
                const float length = glm::length(stage.shaded.ray.direction);
                const auto alphas = i % 4 == 0 ? std::vector<float>(5, 0.1f)
                                               : std::vector { someAlpha(exam.random), 0.2f, someAlpha(exam.random) };
                expectThroughPanes(exam, stage, alphas,
                    fmt::format("the view ray's direction {:.2g} long, {} panes in between", length, alphas.size()));
            }
        });

    const Check closePanes("light.transparency.close", 0.5,
        "behind a surface the ray goes on 1e-5 to 1e-3 further: 1e-2 jumps over what stands close to it",
        [](Exam& exam) {
            for (int i = 0; i < 40; ++i) {
                Stage stage = transparentStage(exam.random);
                const LightSample light = randomLight(exam.random, stage);
                const glm::dvec3 toLight = glm::dvec3(light.position) - stage.shaded.point();
                const glm::dvec3 middle = stage.shaded.point() + 0.5 * toLight;
                const glm::dvec3 gap = static_cast<double>(smallGap(exam.random)) * glm::normalize(toLight);
                const std::array<Material, 2> materials { glass(exam.random, 0.3f), glass(exam.random, 0.6f) };
                for (int layer = 0; layer < 2; ++layer)
                    addTriangleAround(stage.scene, middle + static_cast<double>(layer) * gap,
                        glm::normalize(glm::vec3(toLight)), 0.3f, materials[static_cast<std::size_t>(layer)]);
                expectLight(exam, stage, light, passed(materials[0]) * passed(materials[1]),
                    fmt::format("two panes {:.2g} from each other in between", glm::length(gap)));
            }
        });
    const Check opaque(
        "light.transparency.opaque", 0.5, "a surface with transparency 1 is opaque: it leaves nothing", [](Exam& exam) {
            for (std::size_t i = 0; i < 30; ++i) {
                std::vector<float> alphas { 0.5f, 0.5f, 0.5f };
                alphas[i % 3] = 1.0f;
                expectThroughPanes(exam, transparentStage(exam.random), alphas,
                    fmt::format("three panes in between, pane {} opaque", i % 3 + 1));
            }
        });

    const Check paneBehind("light.transparency.behind", 0.5,
        "what lies behind the light does not colour it: after each surface the ray that is left is shorter",
        [](Exam& exam) {
            for (int i = 0; i < 40; ++i) {
                Stage stage = transparentStage(exam.random);
                const LightSample light = randomLight(exam.random, stage);
                const Material before = glass(exam.random, 0.5f);
                addPane(stage, exam.random, light.position, 0.5, before);
                const auto beyond = static_cast<double>(exam.random.uniform(1.1f, 1.4f));
                addPane(stage, exam.random, light.position, beyond, glass(exam.random, 0.5f));
                expectLight(exam, stage, light, passed(before), "a pane in between and one behind the light");
            }
        });

    // A picture with texels of different colours; the middle of the pane has that of one of them.
    const Check textured("light.transparency.textured", 0.5,
        "kd of a surface in between may come from its texture: sampleMaterialKd with the hitInfo of that surface",
        [](Exam& exam) {
            for (int i = 0; i < 20; ++i) {
                Stage stage = transparentStage(exam.random);
                stage.features.enableTextureMapping = true;
                Image image(4, 4);
                for (int texel = 0; texel < 16; ++texel)
                    image.set_pixel(texel, exam.random.color());
                const auto texture = std::make_shared<const Image>(image);
                stage.scene.textures.push_back(texture);
                Material material = glass(exam.random, 0.5f);
                material.kdTexture = texture.get();
                const LightSample light = randomLight(exam.random, stage);
                addPane(stage, exam.random, light.position, 0.5, material);
                const glm::ivec2 texel { exam.random.integer(0, 3), exam.random.integer(0, 3) };
                const glm::vec2 middle = (glm::vec2(texel) + 0.5f) / 4.0f;
                const std::array<glm::vec2, 3> offsets { { { 0.2f, 0.0f }, { -0.1f, 0.15f }, { -0.1f, -0.15f } } };
                for (std::size_t corner = 0; corner < 3; ++corner)
                    stage.scene.meshes[0].vertices[corner].texCoord = middle + offsets[corner];
                material.kd = image.get_pixel(texel.y * 4 + texel.x);
                expectLight(exam, stage, light, passed(material), "a textured pane in between");
            }
        });

}
}
