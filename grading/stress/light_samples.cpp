#include "grading/stress/probes/lights.h"
#include "grading/stress/rounding.h"
#include "grading/stress/stress.h"
#include <array>

// Where samples of lights lie and which colour they have.
namespace stress::light_samples {
namespace {

    using grading::LightSample;

    // A place on a light, and with it how far all that is added up may be rounded.
    struct Exact {
        glm::dvec3 position, color, positionSize, colorSize;
    };

    std::string describe(const SegmentSample& query)
    {
        const SegmentLight& light = query.light;
        return fmt::format("sampleSegmentLight({}) from {} to {}, colours {} and {}", exactly(query.sample),
            exactly(light.endpoint0), exactly(light.endpoint1), exactly(light.color0), exactly(light.color1));
    }

    std::string describe(const ParallelogramSample& query)
    {
        const ParallelogramLight& light = query.light;
        return fmt::format("sampleParallelogramLight({}) of {}, edges {} and {}, colours {}, {}, {} and {}",
            exactly(query.sample), exactly(light.v0), exactly(light.edge01), exactly(light.edge02),
            exactly(light.color0), exactly(light.color1), exactly(light.color2), exactly(light.color3));
    }

    Exact exactAt(const SegmentLight& light, double s)
    {
        const glm::dvec3 start(light.endpoint0), end(light.endpoint1), color0(light.color0), color1(light.color1);
        return { glm::mix(start, end, s), glm::mix(color0, color1, s), glm::abs(start) + glm::abs(end),
            color0 + color1 };
    }

    Exact exactAt(const ParallelogramLight& light, const glm::dvec2& s)
    {
        const glm::dvec3 v0(light.v0), edge01(light.edge01), edge02(light.edge02);
        const glm::dvec3 color0(light.color0), color1(light.color1), color2(light.color2), color3(light.color3);
        return { v0 + s.x * edge01 + s.y * edge02,
            glm::mix(glm::mix(color0, color1, s.x), glm::mix(color2, color3, s.x), s.y),
            glm::abs(v0) + glm::abs(edge01) + glm::abs(edge02), color0 + color1 + color2 + color3 };
    }

    // Each way to calculate rounds what it adds up three times or fewer for each direction.
    constexpr double boundOfPosition = 4.0, boundOfColor = 4.0;

    Judgement judgeExact(const LightSample& came, const Exact& exact)
    {
        const Judgement position = judgeUlps(came.position, exact.position, exact.positionSize, boundOfPosition);
        const Judgement color = judgeUlps(came.color, exact.color, exact.colorSize, boundOfColor);
        if (!position.isRight || !color.isRight)
            return position.isRight ? color : position;
        if (!glm::all(glm::greaterThanEqual(came.color, glm::vec3(0.0f))))
            return wrong(exactly(came.color), "a colour");
        return right(std::max(position.ulps, color.ulps));
    }

    // From either end: as long as the colour goes with the position that is as uniform.
    Judgement judgeSegment(const SegmentSample& query, const LightSample& came)
    {
        const auto s = static_cast<double>(query.sample);
        const Judgement reversed = judgeExact(came, exactAt(query.light, 1.0 - s));
        return reversed.isRight ? reversed : judgeExact(came, exactAt(query.light, s));
    }

    // From any corner, along either edge first.
    Judgement judgeParallelogram(const ParallelogramSample& query, const LightSample& came)
    {
        const glm::dvec2 s(query.sample);
        for (const glm::dvec2& from : { s, glm::dvec2(s.y, s.x) })
            for (const glm::dvec2& place : { from, glm::dvec2(1.0 - from.x, from.y), glm::dvec2(from.x, 1.0 - from.y),
                     glm::dvec2(1.0 - from.x, 1.0 - from.y) })
                if (const Judgement judgement = judgeExact(came, exactAt(query.light, place)); judgement.isRight)
                    return judgement;
        return judgeExact(came, exactAt(query.light, s));
    }

    const Question<SegmentSample, LightSample> segment { "stress.segment", describe, judgeSegment };
    const Question<ParallelogramSample, LightSample> parallelogram { "stress.parallelogram", describe,
        judgeParallelogram };

    constexpr float last = 0x1.fffffep-1f; // below 1

    float sampleOf(Random& random)
    {
        const std::array<float, 4> extremes { 0.0f, last, 0x1p-24f, 0.5f };
        const auto any = static_cast<std::size_t>(random.integer(0, 15));
        return any < extremes.size() ? extremes[any] : random.uniform();
    }

    glm::vec3 anyVector(Random& random)
    {
        const float size = magnitude(random, 1e-6f, 1e6f);
        return random.vec3(-size, size);
    }

    SegmentSample anySegment(Random& random)
    {
        const glm::vec3 start = anyVector(random);
        const glm::vec3 end = random.integer(0, 7) == 0 ? start : start + anyVector(random);
        const glm::vec3 color = magnitude(random, 1e-6f, 1e6f) * random.color();
        return { { start, end, color, random.color() }, sampleOf(random) };
    }

    ParallelogramSample anyParallelogram(Random& random)
    {
        ParallelogramLight light {};
        light.v0 = anyVector(random);
        light.edge01 = anyVector(random);
        light.edge02 = random.integer(0, 3) == 0 ? random.uniform(-2.0f, 2.0f) * light.edge01 : anyVector(random);
        for (glm::vec3* color : { &light.color0, &light.color1, &light.color2, &light.color3 })
            *color = random.integer(0, 7) == 0 ? glm::vec3(0.0f) : magnitude(random, 1e-6f, 1e6f) * random.color();
        const float x = sampleOf(random);
        return { light, { x, sampleOf(random) } };
    }

    const Stress segments("light.segment.anywhere", segment, randomly<SegmentSample>(600'000, anySegment));
    const Stress parallelograms(
        "light.parallelogram.anywhere", parallelogram, randomly<ParallelogramSample>(600'000, anyParallelogram));

    constexpr glm::vec3 a { 1.0f, -2.0f, 3.0f }, b { -4.0f, 0.5f, 3.0f }, zero { 0.0f };
    constexpr glm::vec3 red { 1.0f, 0.0f, 0.0f }, sky { 0.2f, 0.4f, 0.9f }, huge { 1e30f }, grey { 0.3f };

    const Stress specialSegments("light.segment.special", segment,
        constructed<SegmentSample>({
            { "sample 0", { { a, b, red, sky }, 0.0f } },
            { "sample just below 1", { { a, b, red, sky }, last } },
            { "the least sample", { { a, b, red, sky }, 0x1p-24f } },
            { "zero length", { { a, a, red, sky }, 0.7f } },
            { "zero length in the origin", { { zero, zero, red, sky }, 0.3f } },
            { "ends one float apart", { { a, { 0x1.000002p0f, -2.0f, 3.0f }, red, sky }, 0.6f } },
            { "ends far from the origin, close together",
                { { glm::vec3(1e6f), glm::vec3(1e6f + 1.0f), red, sky }, 0.6f } },
            { "opposite ends", { { glm::vec3(-1e6f), glm::vec3(1e6f), red, sky }, 0.5f } },
            { "huge", { { -huge, huge, red, sky }, 0.25f } },
            { "no light", { { a, b, zero, zero }, 0.5f } },
            { "huge light and none", { { a, b, huge, zero }, last } },
            { "equal colours", { { a, b, sky, sky }, 0.1f } },
        }));

    ParallelogramLight coloured(const glm::vec3& v0, const glm::vec3& edge01, const glm::vec3& edge02)
    {
        return { v0, edge01, edge02, red, sky, grey, glm::vec3(1.0f) };
    }

    const Stress specialParallelograms("light.parallelogram.special", parallelogram,
        constructed<ParallelogramSample>({
            { "sample 0", { coloured(a, b, { 0.0f, 1.0f, 0.0f }), { 0.0f, 0.0f } } },
            { "sample just below 1", { coloured(a, b, { 0.0f, 1.0f, 0.0f }), { last, last } } },
            { "samples 0 and just below 1", { coloured(a, b, { 0.0f, 1.0f, 0.0f }), { 0.0f, last } } },
            { "collinear edges", { coloured(a, b, 2.0f * b), { 0.3f, 0.6f } } },
            { "opposite edges", { coloured(a, b, -b), { 0.5f, 0.5f } } },
            { "one edge 0", { coloured(a, zero, b), { 0.3f, 0.6f } } },
            { "both edges 0", { coloured(a, zero, zero), { 0.3f, 0.6f } } },
            { "all 0", { coloured(zero, zero, zero), { 0.3f, 0.6f } } },
            { "edges smaller than the position's last place",
                { coloured(glm::vec3(1e6f), glm::vec3(1e-3f), { 1e-3f, 0.0f, 0.0f }), { 0.3f, 0.6f } } },
            { "huge", { coloured(-huge, huge, { 1e30f, 0.0f, 0.0f }), { 0.3f, 0.6f } } },
            { "no light", { { a, b, red, zero, zero, zero, zero }, { 0.3f, 0.6f } } },
            { "light in one corner", { { a, b, red, zero, zero, zero, huge }, { 0.3f, 0.6f } } },
        }));

}
}
