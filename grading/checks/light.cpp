#include "grading/check.h"
#include "grading/expect.h"
#include "grading/picture.h"
#include "grading/probes/light_sample.h"
#include "worker/scene_message.h"
#include <array>
#include <fmt/format.h>

// Where samples of lights lie and which colour they have, and pictures.
namespace grading::light {
namespace {

    // A place on a light: the fraction of the way along each of its edges.
    using Place = glm::dvec2;

    // A segment is a parallelogram whose second edge is 0 long.
    struct Area {
        glm::dvec3 v0, edge01, edge02;
        std::array<glm::dvec3, 4> colors;

        [[nodiscard]] glm::dvec3 positionAt(const Place& p) const { return v0 + p.x * edge01 + p.y * edge02; }

        [[nodiscard]] glm::dvec3 colorAt(const Place& p) const
        {
            return glm::mix(glm::mix(colors[0], colors[1], p.x), glm::mix(colors[2], colors[3], p.x), p.y);
        }
    };

    Area areaOf(const SegmentLight& light)
    {
        const glm::dvec3 color0 { light.color0 }, color1 { light.color1 };
        return { glm::dvec3(light.endpoint0), glm::dvec3(light.endpoint1) - glm::dvec3(light.endpoint0),
            glm::dvec3(0.0), { color0, color1, color0, color1 } };
    }

    Area areaOf(const ParallelogramLight& light)
    {
        return { glm::dvec3(light.v0), glm::dvec3(light.edge01), glm::dvec3(light.edge02),
            { glm::dvec3(light.color0), glm::dvec3(light.color1), glm::dvec3(light.color2),
                glm::dvec3(light.color3) } };
    }

    glm::vec3 randomEdge(Random& random)
    {
        const float length = random.uniform(1.0f, 2.0f);
        return length * random.direction();
    }

    SegmentLight randomSegment(Random& random)
    {
        const glm::vec3 start = random.vec3(-3.0f, 3.0f);
        const glm::vec3 end = start + randomEdge(random);
        const glm::vec3 color = random.color();
        return { start, end, color, random.color() };
    }

    ParallelogramLight randomParallelogram(Random& random)
    {
        ParallelogramLight light {};
        light.v0 = random.vec3(-3.0f, 3.0f);
        light.edge01 = randomEdge(random);
        const glm::vec3 across = glm::normalize(glm::cross(light.edge01, random.direction()));
        light.edge02 = random.uniform(1.0f, 2.0f) * across + 0.3f * light.edge01; // not a rectangle
        for (glm::vec3* color : { &light.color0, &light.color1, &light.color2, &light.color3 })
            *color = random.color();
        return light;
    }

    // Samples in [0, 1), both ends of it included.
    std::vector<float> samplesOf(Random& random, const SegmentLight&)
    {
        std::vector<float> samples { 0.0f, 0x1.fffffep-1f };
        for (int i = 0; i < 30; ++i)
            samples.push_back(random.uniform());
        return samples;
    }

    std::vector<glm::vec2> samplesOf(Random& random, const ParallelogramLight&)
    {
        std::vector<glm::vec2> samples { { 0.0f, 0.0f } };
        for (int i = 0; i < 60; ++i)
            samples.push_back(random.vec2());
        return samples;
    }

    Place placeOf(float sample)
    {
        return { sample, 0.0 };
    }
    Place placeOf(const glm::vec2& sample)
    {
        return Place(sample);
    }

    // The ways to lay the unit square onto a parallelogram: each is as uniform as the others.
    constexpr int numLayouts = 8;

    Place laidOut(Place place, int layout)
    {
        if (layout & 4)
            place = { place.y, place.x };
        return { layout & 1 ? 1.0 - place.x : place.x, layout & 2 ? 1.0 - place.y : place.y };
    }

    // What was sampled, and what came.
    template <typename Light> struct Sampled {
        std::string function;
        Light light;
        std::vector<Place> places;
        std::vector<LightSample> came;

        [[nodiscard]] std::string asked(std::size_t i, const std::string& value) const
        {
            return fmt::format("{} of {} at {}", value, function, toText(glm::vec2(places[i])));
        }

        [[nodiscard]] double distanceTo(std::size_t i, int layout) const
        {
            return glm::distance(glm::dvec3(came[i].position), areaOf(light).positionAt(laidOut(places[i], layout)));
        }

        // Coordinates of up to 5 are rounded a few times.
        [[nodiscard]] bool isLaidOut(int layout) const
        {
            bool all = true;
            for (std::size_t i = 0; i < came.size(); ++i)
                all &= distanceTo(i, layout) <= fewRoundings;
            return all;
        }

        // -1: none, the positions are wrong
        [[nodiscard]] int layout() const
        {
            for (int layout = 0; layout < numLayouts; ++layout)
                if (isLaidOut(layout))
                    return layout;
            return -1;
        }
    };

    template <typename Light>
    Sampled<Light> sample(Exam& exam, const std::string& probe, const std::string& function, const Light& light)
    {
        const auto samples = samplesOf(exam.random, light);
        Sampled<Light> sampled { function, light, {}, exam.ask<std::vector<LightSample>>(probe, light, samples) };
        for (const auto& s : samples)
            sampled.places.push_back(placeOf(s));
        expectCount(function, sampled.came.size(), samples.size());
        return sampled;
    }

    Sampled<SegmentLight> sampleSegment(Exam& exam)
    {
        return sample(exam, "light.sample_segment", "sampleSegmentLight", randomSegment(exam.random));
    }

    Sampled<ParallelogramLight> sampleParallelogram(Exam& exam)
    {
        return sample(exam, "light.sample_parallelogram", "sampleParallelogramLight", randomParallelogram(exam.random));
    }

    template <typename Light> void expectPositions(const Sampled<Light>& sampled)
    {
        if (sampled.layout() >= 0)
            return;
        for (std::size_t i = 0; i < sampled.came.size(); ++i)
            expectNear(sampled.asked(i, "the position"), sampled.came[i].position,
                areaOf(sampled.light).positionAt(sampled.places[i]), fewRoundings);
    }

    // The colour is that of the position; where that is wrong, which costs points already, that of the sample.
    template <typename Light> void expectColors(const Sampled<Light>& sampled)
    {
        const int layout = std::max(sampled.layout(), 0);
        for (std::size_t i = 0; i < sampled.came.size(); ++i)
            expectNear(sampled.asked(i, "the colour"), sampled.came[i].color,
                areaOf(sampled.light).colorAt(laidOut(sampled.places[i], layout)), fewRoundings);
    }

    const Check segmentPosition("light.segment.position", 1.0,
        "the position goes from endpoint0 at 0 to endpoint1 at 1",
        [](Exam& exam) { expectPositions(sampleSegment(exam)); });
    const Check segmentColor("light.segment.color", 1.0,
        "the colour goes the same way as the position: color0 belongs to endpoint0",
        [](Exam& exam) { expectColors(sampleSegment(exam)); });
    const Check parallelogramPosition("light.parallelogram.position", 1.0,
        "the position is v0 + sample.x * edge01 + sample.y * edge02: both edges start at v0",
        [](Exam& exam) { expectPositions(sampleParallelogram(exam)); });
    const Check parallelogramColor("light.parallelogram.color", 1.0,
        "color1 lies at v0 + edge01, color2 at v0 + edge02, color3 opposite v0, and between them the colour is "
        "bilinear",
        [](Exam& exam) { expectColors(sampleParallelogram(exam)); });

    const Check hardShadows("light.picture.hard_shadows", 0.75, "see the checks of visibilityOfLightSampleBinary",
        [](Exam& exam) { comparePicture(exam, pictureOf("hard_shadows")); });
    const Check transparentShadows("light.picture.transparent_shadows", 0.75,
        "see the checks of visibilityOfLightSampleTransparency",
        [](Exam& exam) { comparePicture(exam, pictureOf("transparent_shadows")); });
    const Check softShadows(
        "light.picture.soft_shadows", 0.5, "see the checks of segment and parallelogram lights", [](Exam& exam) {
            comparePicture(exam, pictureOf("soft_shadows", { { "shadow_samples", "4" } }));
        });

}
}
