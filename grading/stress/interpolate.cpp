#include "grading/oracle/triangle.h"
#include "grading/stress/oracle/crossing.h"
#include "grading/stress/shapes.h"
#include "grading/stress/stress.h"
#include "grading/stress/text.h"

namespace stress::interpolate {
namespace {

    using grading::Triangle;
    using grading::TrianglePoint;

    std::string describe(const TrianglePoint& input)
    {
        const auto& [v0, v1, v2] = input.triangle;
        return fmt::format(
            "computeBarycentricCoord of {}, {}, {} at {}", exactly(v0), exactly(v1), exactly(v2), exactly(input.p));
    }

    // How far the point of these coordinates may be beyond the closest one: some roundings of the largest length there
    // is. Areas have as many more as the triangle is slender, and a triangle so slender that they are lost may count as
    // its edges, which are no farther than it is high.
    double boundOf(const TrianglePoint& input)
    {
        const auto [a, b, c] = grading::cornersOf(input.triangle);
        const glm::dvec3 p { input.p };
        const double reach = std::max({ glm::distance(a, p), glm::distance(b, p), glm::distance(c, p) });
        const double slenderness = grading::slenderness(input.triangle);
        const double lost = std::min(32.0 * rounding * slenderness, 4.0 / slenderness);
        return reach * (32.0 * rounding + (std::isfinite(slenderness) ? lost : 0.0));
    }

    // Each in [0, 1], a sum of 1 within two units of its last place, and no point is closer.
    Judgement judge(const TrianglePoint& input, const glm::vec3& came)
    {
        const glm::dvec3 weights { came }, p { input.p };
        const double ulps = std::abs(weights.x + weights.y + weights.z - 1.0) / (2.0 * rounding);
        const bool areWeights = glm::all(glm::greaterThanEqual(weights, glm::dvec3(0.0)))
            && glm::all(glm::lessThanEqual(weights, glm::dvec3(1.0))) && ulps <= 2.0;
        const grading::Corners corners = grading::cornersOf(input.triangle);
        const glm::dvec3 closest = grading::closestPoint(corners, p);
        const double distance = glm::distance(grading::pointAt(corners, weights), p);
        const double expected = glm::distance(grading::pointAt(corners, closest), p);
        const double bound = boundOf(input);
        if (areWeights && distance <= expected + bound)
            return right(ulps);
        return wrong(fmt::format("{}, {} away, the sum off by {:.3g} ulps", exactly(came), exactly(distance), ulps),
            fmt::format("{}, {} +- {:.2g} away, in [0, 1], the sum off by 2 ulps at most", exactly(closest),
                exactly(expected), bound),
            ulps);
    }

    const Question<TrianglePoint, glm::vec3> barycentric { "stress.barycentric", describe, judge };

    // On the triangle, close to it or in the space about it.
    TrianglePoint make(Random& random, const Setting& setting)
    {
        const Frame frame = randomFrame(random);
        const Triangle triangle = triangleIn(frame, random, setting);
        const glm::vec3 point
            = pointOf(triangle, random.integer(0, 1) == 0 ? weightsInside(random) : weightsAround(random));
        const float heights[] { 0.0f, magnitude(random, 1e-7f, 1.0f), random.uniform(-3.0f, 3.0f) };
        return { triangle, point + setting.size * heights[random.integer(0, 2)] * frame.up };
    }

    const Stress scales(
        "interpolate.barycentric.scales", barycentric, randomly<TrianglePoint>(400'000, [](Random& random) {
            return make(
                random, { .size = magnitude(random, 1e-6f, 1e6f), .slenderness = magnitude(random, 1.0f, 10.0f) });
        }));
    const Stress needles(
        "interpolate.barycentric.needles", barycentric, randomly<TrianglePoint>(400'000, [](Random& random) {
            return make(
                random, { .size = magnitude(random, 1e-3f, 1e3f), .slenderness = magnitude(random, 1.0f, 1e7f) });
        }));
    // Corners along a segment, or all one point; coordinates with few digits, so that there is no area at all.
    const Stress collapsed(
        "interpolate.barycentric.collapsed", barycentric, randomly<TrianglePoint>(200'000, [](Random& random) {
            const auto whole = [&] { return static_cast<float>(random.integer(-8, 8)); };
            const glm::vec3 start { whole(), whole(), whole() }, step { whole(), whole(), whole() };
            const auto corner = [&] { return start + static_cast<float>(random.integer(0, 3)) * step; };
            const Triangle triangle { corner(), corner(), corner() };
            return TrianglePoint { triangle, pointOf(triangle, weightsAround(random)) + whole() * random.vec3() };
        }));

    const Triangle flat { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } };
    const Triangle point { glm::vec3(1), glm::vec3(1), glm::vec3(1) };
    const Triangle segment { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 0, 0 } };
    const Triangle needle { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5f, 1e-7f, 0 } };

    const Stress special("interpolate.barycentric.special", barycentric,
        constructed<TrianglePoint>({
            { "corner 0", { flat, { 0, 0, 0 } } },
            { "corner 1", { flat, { 4, 0, 0 } } },
            { "corner 2", { flat, { 0, 4, 0 } } },
            { "the middle of edge 01", { flat, { 2, 0, 0 } } },
            { "the middle of edge 12", { flat, { 2, 2, 0 } } },
            { "the middle of edge 20", { flat, { 0, 2, 0 } } },
            { "beyond corner 0", { flat, { -1, -1, 0 } } },
            { "beyond corner 1", { flat, { 9, -1, 0 } } },
            { "beyond corner 2", { flat, { -1, 9, 0 } } },
            { "beyond edge 01", { flat, { 1, -2, 0 } } },
            { "beyond edge 12", { flat, { 5, 4, 0 } } },
            { "beyond edge 20", { flat, { -3, 1, 0 } } },
            { "above", { flat, { 1, 1, 5 } } },
            { "below a corner", { flat, { 4, 0, -5 } } },
            { "a point, at it", { point, glm::vec3(1) } },
            { "a point, off it", { point, { 1, 2, 3 } } },
            { "a point at the origin", { { {}, {}, {} }, { 0, 0, 0 } } },
            { "a segment, on it", { segment, { 1, 0, 0 } } },
            { "a segment, beside it", { segment, { 3, 1, 0 } } },
            { "a segment, beyond its start", { segment, { -1, 0, 0 } } },
            { "a segment, beyond its end", { segment, { 5, 2, 0 } } },
            { "two equal corners, between", { { { 0, 0, 0 }, { 4, 4, 0 }, { 4, 4, 0 } }, { 2, 2, 0 } } },
            { "two equal corners, first", { { { 0, 0, 0 }, { 0, 0, 0 }, { 4, 4, 4 } }, { 3, 3, 3 } } },
            { "a needle, at its tip", { needle, { 1, 0, 0 } } },
            { "a needle, in its middle", { needle, { 0.5f, 5e-8f, 0 } } },
            { "a needle, above its middle", { needle, { 0.25f, 0, 1 } } },
            { "a needle, beside it", { needle, { 0.75f, -1, 0 } } },
            { "tiny", { { { 0, 0, 0 }, { 1e-6f, 0, 0 }, { 0, 1e-6f, 0 } }, { 2e-7f, 3e-7f, 0 } } },
            { "huge", { { { 0, 0, 0 }, { 1e6f, 0, 0 }, { 0, 1e6f, 0 } }, { 2e5f, 3e5f, 0 } } },
            { "far from the origin",
                { { { 1e6f, 0, 0 }, { 1000001, 0, 0 }, { 1e6f, 1, 0 } }, { 1000000.25f, 0.25f, 0 } } },
        }));

}
}
