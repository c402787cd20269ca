#include "grading/check.h"
#include "grading/expect.h"
#include "grading/oracle/triangle.h"
#include <fmt/format.h>

namespace grading::interpolate {
namespace {

    // Of any shape up to eight times longer than high, about as large as the scale and as far from the origin.
    Triangle randomTriangle(Random& random, float scale = 1.0f)
    {
        for (;;) {
            const Triangle triangle { random.vec3(-1.0f, 1.0f), random.vec3(-1.0f, 1.0f), random.vec3(-1.0f, 1.0f) };
            if (longestEdge(triangle) > 0.3 && slenderness(triangle) < 8.0)
                return { scale * triangle.v0, scale * triangle.v1, scale * triangle.v2 };
        }
    }

    glm::vec3 pointOf(const Triangle& triangle, const glm::vec3& barycentric)
    {
        return glm::vec3(pointAt(cornersOf(triangle), glm::dvec3(barycentric)));
    }

    // Sum 1, each 0.05 or more.
    glm::vec3 weightsInside(Random& random)
    {
        constexpr float margin = 0.05f;
        glm::vec2 uv = random.vec2();
        if (uv.x + uv.y > 1.0f)
            uv = 1.0f - uv;
        const glm::vec2 weights = margin + (1.0f - 3.0f * margin) * uv;
        return { 1.0f - weights.x - weights.y, weights };
    }

    // Sum 1, in [-2, 3], at least one clearly negative: all around the triangle.
    glm::vec3 weightsOutside(Random& random)
    {
        for (;;) {
            const glm::vec2 weights = random.vec2(-2.0f, 3.0f);
            const float rest = 1.0f - weights.x - weights.y;
            if (rest > -2.0f && rest < 3.0f && std::min({ rest, weights.x, weights.y }) < -0.05f)
                return { rest, weights };
        }
    }

    // Coordinates are quotients of areas, or of their squares.
    double toleranceInside(const TrianglePoint& input)
    {
        const double condition = conditionOf(input);
        return 4e-6 * condition * condition; // 30 roundings
    }

    // Who compares squared distances cannot tell points of two edges that are the root of a rounding apart.
    double toleranceOutside(const TrianglePoint& input)
    {
        return toleranceInside(input) + 1e-3 * conditionOf(input);
    }

    std::string describe(const TrianglePoint& input)
    {
        const auto& [v0, v1, v2] = input.triangle;
        return fmt::format(
            "computeBarycentricCoord of {}, {}, {} at {}", toText(v0), toText(v1), toText(v2), toText(input.p));
    }

    // Calls judge(what was asked, input, coordinates) for each.
    template <typename Judge>
    void judgeCoordinates(Exam& exam, const std::vector<TrianglePoint>& inputs, const Judge& judge)
    {
        const auto coordinates = exam.ask<std::vector<glm::vec3>>("interpolate.barycentric", inputs);
        expectCount("computeBarycentricCoord", coordinates.size(), inputs.size());
        for (std::size_t i = 0; i < inputs.size(); ++i)
            judge(describe(inputs[i]), inputs[i], coordinates[i]);
    }

    void compareCoordinates(
        Exam& exam, const std::vector<TrianglePoint>& inputs, double (*tolerance)(const TrianglePoint&))
    {
        judgeCoordinates(
            exam, inputs, [&](const std::string& asked, const TrianglePoint& input, const glm::vec3& came) {
                const glm::dvec3 expected = closestPoint(cornersOf(input.triangle), glm::dvec3(input.p));
                expectNear(asked, came, expected, tolerance(input));
            });
    }

    void compareInside(Exam& exam, float scale)
    {
        std::vector<TrianglePoint> inputs;
        for (int i = 0; i < 100; ++i) {
            const Triangle triangle = randomTriangle(exam.random, scale);
            inputs.push_back({ triangle, pointOf(triangle, weightsInside(exam.random)) });
        }
        compareCoordinates(exam, inputs, toleranceInside);
    }

    // Corners and edges: a rounding may put a point of an edge outside.
    void compareBorder(Exam& exam)
    {
        std::vector<TrianglePoint> inputs;
        for (int i = 0; i < 60; ++i) {
            const Triangle triangle = randomTriangle(exam.random);
            glm::vec3 weights { 0.0f };
            const float s = i % 2 == 0 ? 0.0f : exam.random.uniform();
            weights[i % 3] = 1.0f - s;
            weights[(i + 1) % 3] = s;
            inputs.push_back({ triangle, pointOf(triangle, weights) });
        }
        compareCoordinates(exam, inputs, toleranceInside);
    }

    void compareOutside(Exam& exam)
    {
        std::vector<TrianglePoint> inputs;
        for (int i = 0; i < 200; ++i) {
            const Triangle triangle = randomTriangle(exam.random);
            inputs.push_back({ triangle, pointOf(triangle, weightsOutside(exam.random)) });
        }
        compareCoordinates(exam, inputs, toleranceOutside);
    }

    // Up to the longest edge above or below the plane, half of the feet inside the triangle.
    void compareOffPlane(Exam& exam)
    {
        std::vector<TrianglePoint> inputs;
        for (int i = 0; i < 100; ++i) {
            const Triangle triangle = randomTriangle(exam.random);
            const auto& [v0, v1, v2] = triangle;
            const glm::vec3 normal = glm::normalize(glm::cross(v1 - v0, v2 - v0));
            const float height = exam.random.uniform(-1.0f, 1.0f) * static_cast<float>(longestEdge(triangle));
            const glm::vec3 weights = i % 2 == 0 ? weightsInside(exam.random) : weightsOutside(exam.random);
            inputs.push_back({ triangle, pointOf(triangle, weights) + height * normal });
        }
        compareCoordinates(exam, inputs, toleranceOutside);
    }

    // A point, two equal corners, or three corners in line; exactly: all numbers are small multiples of 1/16.
    Triangle triangleWithoutArea(Random& random)
    {
        const auto multiple = [&] { return static_cast<float>(random.integer(1, 16)) / 16.0f; };
        const glm::vec3 start { multiple(), -multiple(), multiple() };
        const glm::vec3 step { -multiple(), multiple(), multiple() };
        std::array<int, 3> steps {};
        for (int& count : steps)
            count = random.integer(0, 3);
        const auto corner
            = [&](int i) { return start + static_cast<float>(steps[static_cast<std::size_t>(i)]) * step; };
        return { corner(0), corner(1), corner(2) };
    }

    template <typename Judge> void judgeWithoutArea(Exam& exam, const Judge& judge)
    {
        std::vector<TrianglePoint> inputs;
        for (int i = 0; i < 100; ++i) {
            const Triangle triangle = triangleWithoutArea(exam.random);
            // Half of the points lie between corners, where a triangle with area would hold them.
            const glm::vec3 off = i % 2 == 0 ? glm::vec3(0.0f) : exam.random.vec3(-2.0f, 2.0f);
            inputs.push_back({ triangle, pointOf(triangle, weightsInside(exam.random)) + off });
        }
        judgeCoordinates(exam, inputs, judge);
    }

    void compareSum(const std::string& asked, const TrianglePoint&, const glm::vec3& came)
    {
        for (int i = 0; i < 3; ++i)
            expect(came[i] >= -fewRoundings && came[i] <= 1.0 + fewRoundings, asked, toText(came), "each in [0, 1]");
        expectNear("the sum of " + asked, came.x + came.y + came.z, 1.0, fewRoundings);
    }

    // Without area a point has many coordinates: what counts is how far the one that came is from p.
    void compareDistance(const std::string& asked, const TrianglePoint& input, const glm::vec3& came)
    {
        compareSum(asked, input, came);
        const Corners corners = cornersOf(input.triangle);
        const glm::dvec3 p { input.p };
        const glm::dvec3 point = pointAt(corners, glm::dvec3(came));
        const glm::dvec3 closest = pointAt(corners, closestPoint(corners, p));
        constexpr double tolerance = 10.0 * fewRoundings; // coordinates within 1e-5, of points within 8
        expect(glm::distance(point, p) <= glm::distance(closest, p) + tolerance, asked,
            fmt::format("{}, which is the point {}", toText(came), toText(glm::vec3(point))),
            fmt::format("coordinates of {}", toText(glm::vec3(closest))));
    }

    const Check inside("interpolation.barycentric.inside", 2.0,
        "alpha is the part of the area opposite v0, beta opposite v1, gamma opposite v2; divide as floats",
        [](Exam& exam) { compareInside(exam, 1.0f); });
    const Check scale("interpolation.barycentric.scale", 0.5,
        "nothing depends on the triangle's size: compare with 0 or with its area, not with a fixed small number",
        [](Exam& exam) {
            compareInside(exam, 0.01f);
            compareInside(exam, 100.0f);
        });
    const Check border("interpolation.barycentric.border", 0.5,
        "corners and edges belong to the triangle: a corner has (1, 0, 0), (0, 1, 0) or (0, 0, 1)", compareBorder);
    const Check outside("interpolation.barycentric.outside", 1.5,
        "a point outside gets the coordinates of the closest point of the triangle: on an edge or a corner. Areas need "
        "their sign, and a clamp alone misses the closest point",
        compareOutside);
    const Check offPlane("interpolation.barycentric.off_plane", 0.5,
        "a point above the plane counts as its foot: project the areas on the triangle's normal", compareOffPlane);
    const Check degenerate("interpolation.barycentric.degenerate", 0.5,
        "a triangle without area: dividing by 0 gives NaN", [](Exam& exam) { judgeWithoutArea(exam, compareSum); });
    const Check degenerateClosest("interpolation.barycentric.degenerate_closest", 0.5,
        "a triangle without area is a segment or a point: the closest point lies on one of its edges",
        [](Exam& exam) { judgeWithoutArea(exam, compareDistance); });

}
}
