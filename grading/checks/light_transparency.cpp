#include "grading/check.h"
#include "grading/checks/light_stage.h"
#include "grading/expect.h"
#include "grading/oracle/random_scene.h"
#include <array>
#include <fmt/format.h>

// What transparent surfaces leave of a light at a shaded point.
namespace grading::light_transparency {
namespace {

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

    LightSample randomSample(Random& random, const Stage& stage)
    {
        return { lightPosition(random, stage, random.uniform(0.5f, 5.0f)), random.color() };
    }

    // Panes, the first of them closest to the shaded point; alpha for each.
    void expectThroughPanes(Exam& exam, Stage stage, const std::vector<float>& alphas, const std::string& what)
    {
        const LightSample light = randomSample(exam.random, stage);
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
                expectLight(exam, stage, randomSample(exam.random, stage), glm::dvec3(1.0), "nothing in between");
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

    // Panes across the line from the shaded point to the light: just above the surface, two in the middle, and one just
    // before the light. Bright and clear ones, so that each counts.
    glm::dvec3 addClosePanes(Stage& stage, Random& random, const glm::vec3& light, float gap)
    {
        const glm::vec3 point { stage.shaded.point() };
        const float distance = glm::distance(point, light);
        const glm::vec3 direction = (light - point) / distance;
        glm::dvec3 factor { 1.0 };
        for (const float along : { gap, 0.5f * distance, 0.5f * distance + gap, distance - gap }) {
            Material material = glass(random, 0.1f);
            material.kd = random.vec3(0.5f, 0.9f);
            addTriangleAround(stage.scene, glm::dvec3(point + along * direction), direction, 0.3f, material);
            factor *= passed(material);
        }
        return factor;
    }

    const Check closePanes("light.transparency.close", 0.5,
        "the ray starts, ends, and goes on behind a surface up to 1e-3 beside what it leaves: 1e-2 jumps over what "
        "stands close to it",
        [](Exam& exam) {
            for (int i = 0; i < 40; ++i) {
                Stage stage = transparentStage(exam.random);
                const float distance = exam.random.uniform(1.0f, 3.0f);
                const LightSample light { lightPosition(exam.random, stage, distance), exam.random.color() };
                const float gap = smallGap(exam.random);
                const glm::dvec3 factor = addClosePanes(stage, exam.random, light.position, gap);
                expectLight(exam, stage, light, factor,
                    fmt::format("panes in between, {:.2g} from the surface, each other and the light", gap));
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
                const LightSample light = randomSample(exam.random, stage);
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
                const LightSample light = randomSample(exam.random, stage);
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
