#include "grading/check.h"
#include "grading/checks/light_shading.h"
#include "grading/expect.h"
#include "grading/oracle/brute_force.h"
#include "grading/oracle/random_scene.h"
#include <fmt/format.h>

// The mean of what arrives from samples of a light.
namespace grading::light_area {
namespace {

    // Lights so small that all their points shade alike.
    constexpr float tiny = 1e-4f;

    const LightKind segment { "computeContributionSegmentLight", [](const PointLight& p) -> Scene::SceneLight {
                                 return SegmentLight { p.position, p.position + tiny, p.color, p.color };
                             } };
    const LightKind parallelogram { "computeContributionParallelogramLight",
        [](const PointLight& p) -> Scene::SceneLight {
            return ParallelogramLight { p.position, { tiny, 0, 0 }, { 0, tiny, 0 }, p.color, p.color, p.color,
                p.color };
        } };

    void compareCounts(Exam& exam, const LightKind& kind)
    {
        for (int i = 0; i < 20; ++i) {
            const Stage stage = randomStage(exam.random);
            const PointLight light = randomLight(exam.random, stage);
            for (const uint32_t numSamples : { 1u, 3u, 16u })
                expectNear(kind.asked(stage, light, fmt::format("{} samples", numSamples)),
                    contribution(exam, stage, kind.make(light), numSamples), shadingOf(stage, light), offsetTolerance);
        }
    }

    const Check segmentCount("light.segment.count", 0.5,
        "shade each of numSamples samples, at its position as seen from the point, and divide the sum by numSamples",
        [](Exam& exam) { compareCounts(exam, segment); });
    const Check parallelogramCount("light.parallelogram.count", 0.5,
        "shade each of numSamples samples, at its position as seen from the point, and divide the sum by numSamples",
        [](Exam& exam) { compareCounts(exam, parallelogram); });

    // A sample is shaded like a point light.
    void compareSample(Exam& exam, const LightKind& kind)
    {
        for (int i = 0; i < 20; ++i) {
            PointLight light {};
            const Stage stage
                = shinyStage(exam.random, i % 2 == 0 ? ShadingModel::Phong : ShadingModel::BlinnPhong, light);
            expectNear(kind.asked(stage, light, "a shiny material"), contribution(exam, stage, kind.make(light)),
                shadingOf(stage, light), 2.0 * offsetTolerance);
        }
        expectBlocked(exam, kind);
        expectNoShadow(exam, kind);
        expectThroughPane(exam, kind);
    }

    const Check segmentSample("light.segment.sample", 0.25,
        "shade a sample as if it were a point light: with -ray.direction, and what visibilityOfLightSample leaves",
        [](Exam& exam) { compareSample(exam, segment); });
    const Check parallelogramSample("light.parallelogram.sample", 0.25,
        "shade a sample as if it were a point light: with -ray.direction, and what visibilityOfLightSample leaves",
        [](Exam& exam) { compareSample(exam, parallelogram); });

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
    Moments momentsOfLight(const Stage& stage, const std::vector<LightSample>& samples)
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
        const Moments expected = momentsOfLight(stage, grid);
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

    const Check largeSegment("light.segment.mean", 0.5,
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
            compareMean(exam, segment.function, stage, light, sampleGrid(exam, "light.sample_segment", light, grid));
        });

    const Check largeParallelogram("light.parallelogram.mean", 0.5,
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
            compareMean(exam, parallelogram.function, stage, light,
                sampleGrid(exam, "light.sample_parallelogram", light, grid));
        });

}
}
