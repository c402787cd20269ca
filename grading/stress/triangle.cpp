#include "grading/stress/oracle/crossing.h"
#include "grading/stress/oracle/exact.h"
#include "grading/stress/probes/rays.h"
#include "grading/stress/shapes.h"
#include "grading/stress/stress.h"
#include "grading/stress/text.h"

namespace stress::triangle {
namespace {

    std::string describe(const TriangleRay& input)
    {
        const auto& [v0, v1, v2] = input.triangle;
        return fmt::format(
            "intersectRayWithTriangle of {}, {}, {} by {}", exactly(v0), exactly(v1), exactly(v2), exactly(input.ray));
    }

    std::string toText(const Met& met)
    {
        return met.isHit ? fmt::format("a hit at t = {} with normal {}", exactly(met.t), exactly(met.normal)) : "none";
    }

    Judgement judge(const TriangleRay& input, const Met& met)
    {
        const Crossing crossing(input.triangle, input.ray);
        const double end = static_cast<double>(input.ray.t), t = static_cast<double>(met.t);
        const auto because = [&](const std::string& expected) {
            return wrong(toText(met),
                fmt::format("{}; exact t = {} +- {:.2g}, normal along {}", expected, exactly(crossing.t),
                    crossing.error, exactly(crossing.normal)),
                crossing.ulpsOf(t));
        };
        if (!met.isHit)
            return crossing.isSurelyMet(end) ? because("a hit")
                : met.t == input.ray.t       ? right()
                                             : because("t as it was");
        if (crossing.isSurelyMissed(end) || !(t >= 0.0 && t <= end))
            return because("none");
        if (!crossing.mayBeMetAt(t))
            return because("that distance");
        if (!isNormal(met.normal, crossing, input.ray))
            return because("a unit normal towards where the ray came from");
        return right(std::isfinite(crossing.error) ? crossing.ulpsOf(t) : 0.0);
    }

    const Question<TriangleRay, Met> question { "stress.triangle", describe, judge };

    TriangleRay make(Random& random, const Setting& setting)
    {
        const Frame frame = randomFrame(random);
        const grading::Triangle triangle = triangleIn(frame, random, setting);
        const glm::vec3 weights = random.uniform() < 0.75f ? weightsInside(random) : weightsAround(random);
        return { triangle, rayTo(pointOf(triangle, weights), frame, random, setting) };
    }

    const Stress scales("triangle.scales", question, randomly<TriangleRay>(600'000, [](Random& random) {
        return make(random, { .size = magnitude(random, 1e-6f, 1e6f), .sine = random.uniform(0.05f, 1.0f) });
    }));
    const Stress slivers("triangle.slivers", question, randomly<TriangleRay>(600'000, [](Random& random) {
        return make(random,
            { .size = magnitude(random, 1e-6f, 1e6f),
                .slenderness = magnitude(random, 1.0f, 1e7f),
                .distance = magnitude(random, 1e-3f, 10.0f),
                .sine = random.uniform(0.05f, 1.0f) });
    }));
    const Stress grazing("triangle.grazing", question, randomly<TriangleRay>(600'000, [](Random& random) {
        return make(random, { .distance = magnitude(random, 0.1f, 100.0f), .sine = magnitude(random, 1e-6f, 1.0f) });
    }));
    const Stress far("triangle.far", question, randomly<TriangleRay>(600'000, [](Random& random) {
        return make(random,
            { .size = magnitude(random, 1e-6f, 1e6f),
                .distance = magnitude(random, 1.0f, 1e6f),
                .sine = random.uniform(0.05f, 1.0f) });
    }));
    // Ends before, behind or at the triangle, and begins before or behind it.
    const Stress limited("triangle.limited", question, randomly<TriangleRay>(600'000, [](Random& random) {
        TriangleRay input
            = make(random, { .size = magnitude(random, 1e-3f, 1e3f), .sine = random.uniform(0.05f, 1.0f) });
        const auto t = static_cast<float>(Crossing(input.triangle, input.ray).t);
        const float ends[] { 0.0f, 0.5f * t, t, 1.5f * t };
        input.ray.t = std::abs(ends[random.integer(0, 3)]);
        if (random.integer(0, 3) == 0)
            input.ray.direction = -input.ray.direction;
        return input;
    }));

    // Small whole numbers, with which single precision calculates exactly: the answer has to be exact, edges included.
    Judgement judgeExactly(const TriangleRay& input, const Met& met)
    {
        const std::optional<double> t = exactDistance(input.triangle, input.ray);
        if (met.isHit == t.has_value() && (!t || met.t == static_cast<float>(*t)))
            return right();
        return wrong(toText(met), t ? "a hit at t = " + exactly(*t) : "none");
    }

    const Question<TriangleRay, Met> exact { "stress.triangle", describe, judgeExactly };
    const grading::Triangle flat { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } };
    const glm::vec3 down { 0, 0, -1 };

    const Stress lattice("triangle.exact", exact,
        constructed<TriangleRay>({
            { "through a corner", { flat, { { 0, 0, 1 }, down } } },
            { "through another corner", { flat, { { 4, 0, 1 }, down } } },
            { "through the third corner", { flat, { { 0, 4, 1 }, down } } },
            { "through an edge", { flat, { { 2, 0, 1 }, down } } },
            { "through another edge", { flat, { { 0, 2, 1 }, down } } },
            { "through the third edge", { flat, { { 2, 2, 1 }, down } } },
            { "from below", { flat, { { 1, 1, -3 }, -down } } },
            { "beside", { flat, { { 3, 2, 1 }, down } } },
            { "away from it", { flat, { { 1, 1, 1 }, -down } } },
            { "from on it", { flat, { { 1, 1, 0 }, down } } },
            { "from on its edge", { flat, { { 2, 0, 0 }, down } } },
            { "from on its corner", { flat, { { 4, 0, 0 }, down } } },
            { "ends at it", { flat, { { 1, 1, 2 }, down, 2 } } },
            { "ends before it", { flat, { { 1, 1, 2 }, down, 1 } } },
            { "ends where it begins, on it", { flat, { { 1, 1, 0 }, down, 0 } } },
            { "infinite end", { flat, { { 1, 1, 2 }, down, std::numeric_limits<float>::infinity() } } },
            { "negative end", { flat, { { 1, 1, 2 }, down, -1 } } },
            { "a long direction", { flat, { { 1, 1, 2 }, 8.0f * down } } },
            { "negative zeros", { flat, { { 1, 1, 2 }, { -0.0f, -0.0f, -1 } } } },
            { "in the plane", { flat, { { -1, 1, 0 }, { 1, 0, 0 } } } },
            { "along an edge", { flat, { { -1, 0, 0 }, { 1, 0, 0 } } } },
            { "beside the plane, parallel", { flat, { { -1, 1, 1 }, { 1, 0, 0 } } } },
            { "no direction", { flat, { { 1, 1, 0 }, { 0, 0, 0 } } } },
            { "a point", { { { 1, 1, 0 }, { 1, 1, 0 }, { 1, 1, 0 } }, { { 1, 1, 1 }, down } } },
            { "a segment", { { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 0, 0 } }, { { 1, 0, 1 }, down } } },
            { "a segment of two equal corners", { { { 0, 0, 0 }, { 4, 4, 0 }, { 4, 4, 0 } }, { { 2, 2, 1 }, down } } },
            { "a segment, from beside", { { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 0, 0 } }, { { 1, 1, 1 }, down } } },
            { "a segment, from its end", { { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 0, 0 } }, { { 0, 0, 0 }, down } } },
            { "a needle, a million long",
                { { { 0, 0, 0 }, { 1048576, 0, 0 }, { 0, 1, 0 } }, { { 524288, 0, 1 }, down } } },
            { "a needle from its tip",
                { { { 0, 0, 0 }, { 4096, 0, 0 }, { 4096, 1, 0 } }, { { 0, 0, 64 }, { 2048, 0, -64 } } } },
            { "corners in the other order", { { { 0, 0, 0 }, { 0, 4, 0 }, { 4, 0, 0 } }, { { 1, 1, 1 }, down } } },
            { "tilted, through a corner",
                { { { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 4 } }, { { 6, 2, 2 }, { -1, -1, -1 } } } },
            { "tilted, through an edge",
                { { { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 4 } }, { { 3, 3, 1 }, { -1, -1, -1 } } } },
        }));

}
}
