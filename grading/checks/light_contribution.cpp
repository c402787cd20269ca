#include "grading/check.h"
#include "grading/checks/light_stage.h"
#include "grading/expect.h"
#include "grading/oracle/brute_force.h"
#include "grading/oracle/random_scene.h"
#include <fmt/format.h>

// The shading of what arrives from a light.
namespace grading {
namespace {

    // The direction to the light may be taken from where the shadow ray starts, up to 1e-3 beside the point.
    constexpr double offsetTolerance = 5e-3;

    glm::dvec3 lambert(const Stage& stage, const glm::dvec3& position, const glm::dvec3& color)
    {
        const auto& hit = stage.shaded.hitInfo;
        const double cosine = glm::dot(glm::dvec3(hit.normal), glm::normalize(position - stage.shaded.point()));
        return color * glm::dvec3(hit.material.kd) * std::max(cosine, 0.0);
    }

    // With the part that Phong or Blinn and Phong add.
    glm::dvec3 shiny(const Stage& stage, const PointLight& light)
    {
        const glm::dvec3 normal { stage.shaded.hitInfo.normal };
        const glm::dvec3 toLight = glm::normalize(glm::dvec3(light.position) - stage.shaded.point());
        const glm::dvec3 toCamera = glm::normalize(-glm::dvec3(stage.shaded.ray.direction));
        const double cosine = stage.features.shadingModel == ShadingModel::Phong
            ? glm::dot(2.0 * glm::dot(normal, toLight) * normal - toLight, toCamera)
            : glm::dot(normal, glm::normalize(toLight + toCamera));
        const Material& material = stage.shaded.hitInfo.material;
        const double lobe = std::pow(std::max(cosine, 0.0), static_cast<double>(material.shininess));
        const glm::dvec3 color { light.color };
        return lambert(stage, glm::dvec3(light.position), color) + color * glm::dvec3(material.ks) * lobe;
    }

    std::vector<glm::vec3> contributions(Exam& exam, Stage stage, const Scene::SceneLight& light, uint32_t numSamples,
        const std::vector<uint32_t>& seeds)
    {
        stage.scene.lights = { light };
        auto colors = exam.ask<std::vector<glm::vec3>>("light.contribution", stage, numSamples, seeds);
        expectCount("contributions of lights", colors.size(), seeds.size());
        return colors;
    }

    glm::vec3 contribution(Exam& exam, const Stage& stage, const Scene::SceneLight& light, uint32_t numSamples = 1)
    {
        return contributions(exam, stage, light, numSamples, { exam.random.seed() })[0];
    }

    std::string askedOf(const Stage& stage, const PointLight& light, const std::string& what)
    {
        return fmt::format("computeContributionPointLight {} of colour {}, normal {}, kd {}, {}",
            describe(stage, light.position), toText(light.color), toText(stage.shaded.hitInfo.normal),
            toText(stage.shaded.hitInfo.material.kd), what);
    }

    PointLight randomLight(Random& random, const Stage& stage)
    {
        return { lightPosition(random, stage, random.uniform(1.0f, 3.0f)), random.color() };
    }

    const Check shading("light.point.shading", 1.0,
        "computeShading gets the direction from the point to the light, of length 1, and the light's colour once",
        [](Exam& exam) {
            for (int i = 0; i < 50; ++i) {
                const Stage stage = randomStage(exam.random);
                const PointLight light = randomLight(exam.random, stage);
                expectNear(askedOf(stage, light, "nothing in between"), contribution(exam, stage, light),
                    lambert(stage, glm::dvec3(light.position), glm::dvec3(light.color)), offsetTolerance);
            }
        });

    const Check view("light.point.view", 1.0,
        "computeShading gets the direction from the point to the camera, -ray.direction, with the light's direction "
        "second",
        [](Exam& exam) {
            for (const ShadingModel model : { ShadingModel::Phong, ShadingModel::BlinnPhong }) {
                for (int i = 0; i < 30; ++i) {
                    Stage stage = randomStage(exam.random);
                    stage.features.shadingModel = model;
                    // Near the mirrored view ray, where the highlight is.
                    const glm::vec3 mirrored = glm::reflect(stage.shaded.ray.direction, stage.shaded.hitInfo.normal);
                    const glm::vec3 toLight = glm::normalize(mirrored + 0.2f * exam.random.direction());
                    const PointLight light { glm::vec3(stage.shaded.point()) + 2.0f * toLight, exam.random.color() };
                    expectNear(askedOf(stage, light, "a shiny material"), contribution(exam, stage, light),
                        shiny(stage, light), 2.0 * offsetTolerance);
                }
            }
        });

    // Compares a blocked light with the same light unblocked: how it is shaded has a check of its own.
    void comparePane(
        Exam& exam, float alpha, Features features, const glm::dvec3& expectedOfOne, const std::string& what)
    {
        for (int i = 0; i < 30; ++i) {
            Stage stage = randomStage(exam.random);
            stage.features = features;
            const PointLight light = randomLight(exam.random, stage);
            const glm::vec3 open = contribution(exam, stage, light);
            Material material = randomMaterial(exam.random);
            material.kd = glm::vec3(0.9f, 0.6f, 0.3f);
            material.transparency = alpha;
            addPane(stage, exam.random, light.position, 0.5, material);
            const bool isLit = open.x > 0.0f && open.y > 0.0f && open.z > 0.0f;
            expect(isLit, askedOf(stage, light, "nothing in between"), toText(open), "light");
            expectNear(askedOf(stage, light, what), contribution(exam, stage, light), glm::dvec3(open) * expectedOfOne,
                fewRoundings);
        }
    }

    const Features shadows { .enableShading = true, .enableShadows = true, .enableAccelStructure = true };

    const Check blocked("light.point.blocked", 0.5,
        "a light that is not visible contributes nothing: ask visibilityOfLightSample",
        [](Exam& exam) { comparePane(exam, 1.0f, shadows, glm::dvec3(0.0), "a triangle in between"); });
    const Check off("light.point.shadows_off", 0.5, "with shadows off every light is visible", [](Exam& exam) {
        comparePane(exam, 1.0f, { .enableShading = true, .enableAccelStructure = true }, glm::dvec3(1.0),
            "a triangle in between, shadows off");
    });
    const Check pane("light.point.pane", 0.5,
        "the colour that visibilityOfLightSample returns is what is shaded, in place of the light's own",
        [](Exam& exam) {
            Features features = shadows;
            features.enableTransparency = true;
            comparePane(exam, 0.5f, features, { 0.45, 0.3, 0.15 },
                "a pane with kd (0.9, 0.6, 0.3) and transparency 0.5 in between");
        });

    // A light so small that all its points shade alike.
    constexpr float tiny = 1e-4f;

    template <typename MakeLight>
    void compareTinyLight(Exam& exam, const std::string& function, const MakeLight& makeLight)
    {
        for (int i = 0; i < 20; ++i) {
            const Stage stage = randomStage(exam.random);
            const PointLight point = randomLight(exam.random, stage);
            for (const uint32_t numSamples : { 1u, 3u, 16u })
                expectNear(fmt::format("{} {} of colour {} and hardly any size, {} samples", function,
                               describe(stage, point.position), toText(point.color), numSamples),
                    contribution(exam, stage, makeLight(point), numSamples),
                    lambert(stage, glm::dvec3(point.position), glm::dvec3(point.color)), offsetTolerance);
        }
    }

    const std::string segmentFunction = "computeContributionSegmentLight";
    const std::string parallelogramFunction = "computeContributionParallelogramLight";

    const Check tinySegment("light.segment.count", 0.5,
        "shade each of numSamples samples, at its position as seen from the point, and divide the sum by numSamples",
        [](Exam& exam) {
            compareTinyLight(exam, segmentFunction, [](const PointLight& p) {
                return SegmentLight { p.position, p.position + tiny, p.color, p.color };
            });
        });
    const Check tinyParallelogram("light.parallelogram.count", 0.5,
        "shade each of numSamples samples, at its position as seen from the point, and divide the sum by numSamples",
        [](Exam& exam) {
            compareTinyLight(exam, parallelogramFunction, [](const PointLight& p) {
                return ParallelogramLight { p.position, { tiny, 0, 0 }, { 0, tiny, 0 }, p.color, p.color, p.color,
                    p.color };
            });
        });

    struct Moments {
        glm::dvec3 mean { 0.0 };
        glm::dvec3 deviation { 0.0 };
    };

    template <typename T, typename F> Moments momentsOf(const std::vector<T>& values, const F& f)
    {
        Moments moments;
        glm::dvec3 squares { 0.0 };
        const auto count = static_cast<double>(values.size());
        for (const T& value : values) {
            moments.mean += f(value) / count;
            squares += f(value) * f(value) / count;
        }
        moments.deviation = glm::sqrt(glm::max(squares - moments.mean * moments.mean, 0.0));
        return moments;
    }

    // The shading of a light's points, seen past what is in between.
    Moments shadingOf(const Stage& stage, const std::vector<LightSample>& samples)
    {
        return momentsOf(samples, [&](const LightSample& sample) {
            const glm::dvec3 position { sample.position };
            return isBlocked(stage.scene, stage.shaded.point(), position)
                ? glm::dvec3(0.0)
                : lambert(stage, position, glm::dvec3(sample.color));
        });
    }

    // A point, something in its way to a part of the light, and the light's middle.
    Stage halfShadow(Random& random, glm::vec3& middle)
    {
        Stage stage = randomStage(random);
        const glm::vec3 normal = stage.shaded.hitInfo.normal;
        middle = lightPosition(random, stage, 1.5f, 0.8f);
        const glm::dvec3 beside = stage.shaded.point() + 0.5 * (glm::dvec3(middle) - stage.shaded.point())
            + 0.1 * glm::dvec3(random.direction());
        addTriangleAround(stage.scene, beside, normal, 0.25f, randomMaterial(random));
        return stage;
    }

    // The mean of many calls against that of the submission's own light samples on a fine grid: whether those are right
    // has checks of its own.
    void compareMean(Exam& exam, const std::string& function, const Stage& stage, const Scene::SceneLight& light,
        const std::vector<LightSample>& grid)
    {
        constexpr uint32_t numSamples = 16;
        constexpr std::size_t numCalls = 4000;
        // Normally distributed means are this many standard errors off with probability 2e-9. Better spread samples
        // vary less than independent ones, whose deviation is used.
        constexpr double standardErrors = 6.0;
        constexpr double maxSpread = 1.3; // of 4000 calls it is known to 3 %; each sample taken twice makes it 1.41
        constexpr double gridTolerance = 4e-3; // of the grid at shadow edges, and of what offsetTolerance is for

        std::vector<uint32_t> seeds(numCalls);
        for (uint32_t& seed : seeds)
            seed = exam.random.seed();
        const auto came = contributions(exam, stage, light, numSamples, seeds);
        const Moments calls = momentsOf(came, [](const glm::vec3& color) { return glm::dvec3(color); });
        const Moments expected = shadingOf(stage, grid);
        const std::string asked
            = fmt::format("{} at {}, a part of the light in shadow", function, toText(glm::vec3(stage.shaded.point())));
        expect(!(glm::length(calls.deviation) < 1e-3 * glm::length(expected.deviation)), asked,
            fmt::format("{} for every seed", toText(came[0])), "values that vary with state.sampler");
        const glm::dvec3 tolerance
            = standardErrors * expected.deviation / std::sqrt(static_cast<double>(numCalls * numSamples))
            + gridTolerance;
        for (int c = 0; c < 3; ++c)
            expect(std::abs(calls.mean[c] - expected.mean[c]) <= tolerance[c],
                fmt::format("the mean of {} calls with {} samples of {}", numCalls, numSamples, asked),
                toText(glm::vec3(calls.mean)), toText(glm::vec3(expected.mean)));
        const double independent = glm::length(expected.deviation) / std::sqrt(static_cast<double>(numSamples));
        expect(glm::length(calls.deviation) < maxSpread * independent,
            fmt::format("the spread of calls with {} samples of {}", numSamples, asked),
            fmt::format("{:.3g}", glm::length(calls.deviation)),
            fmt::format("{:.3g}, as of samples that do not repeat each other", independent));
    }

    template <typename Sample, typename Light>
    std::vector<LightSample> sampleGrid(
        Exam& exam, const std::string& probe, const Light& light, const std::vector<Sample>& grid)
    {
        auto samples = exam.ask<std::vector<LightSample>>(probe, light, grid);
        expectCount(probe, samples.size(), grid.size());
        return samples;
    }

    const Check largeSegment("light.segment.mean", 0.75,
        "every sample takes its own number from state.sampler, its own colour and its own visibility; shade each, then "
        "average",
        [](Exam& exam) {
            glm::vec3 middle;
            const Stage stage = halfShadow(exam.random, middle);
            const glm::vec3 half
                = 0.6f * glm::normalize(glm::cross(stage.shaded.hitInfo.normal, exam.random.direction()));
            const SegmentLight light { middle - half, middle + half, { 0.9f, 0.5f, 0.2f }, { 0.2f, 0.6f, 0.8f } };
            std::vector<float> grid;
            for (int i = 0; i < 4096; ++i)
                grid.push_back((static_cast<float>(i) + 0.5f) / 4096.0f);
            compareMean(exam, segmentFunction, stage, light, sampleGrid(exam, "light.sample_segment", light, grid));
        });

    const Check largeParallelogram("light.parallelogram.mean", 0.75,
        "every sample takes two numbers of its own from state.sampler, its own colour and its own visibility; shade "
        "each, "
        "then average",
        [](Exam& exam) {
            glm::vec3 middle;
            const Stage stage = halfShadow(exam.random, middle);
            const glm::vec3 edge01 = glm::normalize(glm::cross(stage.shaded.hitInfo.normal, exam.random.direction()));
            const glm::vec3 edge02 = glm::cross(stage.shaded.hitInfo.normal, edge01);
            const ParallelogramLight light { middle - 0.5f * (edge01 + edge02), edge01, edge02, { 0.9f, 0.2f, 0.3f },
                { 0.3f, 0.8f, 0.2f }, { 0.2f, 0.3f, 0.9f }, { 0.8f, 0.7f, 0.1f } };
            std::vector<glm::vec2> grid;
            for (int i = 0; i < 128 * 128; ++i)
                grid.push_back((glm::vec2(i % 128, i / 128) + 0.5f) / 128.0f);
            compareMean(
                exam, parallelogramFunction, stage, light, sampleGrid(exam, "light.sample_parallelogram", light, grid));
        });

}
}
