#include "grading/probes/interpolation.h"
#include "grading/stress/stress.h"
#include "grading/stress/text.h"

namespace stress {
namespace {

    using grading::Triangle;
    using grading::TrianglePoint;

    std::string describe(const TrianglePoint& input)
    {
        const auto& [v0, v1, v2] = input.triangle;
        return fmt::format(
            "computeBarycentricCoord of {}, {}, {} at {}", exactly(v0), exactly(v1), exactly(v2), exactly(input.p));
    }

    // Each in [0, 1], and a sum of 1 within two units of its last place.
    Judgement judgeSum(const TrianglePoint&, const glm::vec3& came)
    {
        constexpr double unit = std::numeric_limits<float>::epsilon();
        const glm::dvec3 exact { came };
        const double ulps = std::abs(exact.x + exact.y + exact.z - 1.0) / unit;
        bool isInside = true;
        for (int i = 0; i < 3; ++i)
            isInside &= exact[i] >= 0.0 && exact[i] <= 1.0;
        if (isInside && ulps <= 2.0)
            return right(ulps);
        return wrong(exactly(came), "each in [0, 1], the sum 1 within 2 ulps", ulps);
    }

    const Question<TrianglePoint, glm::vec3> sum { "stress.barycentric", describe, judgeSum };

    const Stress points("interpolate.barycentric.sum", sum, randomly<TrianglePoint>(200'000, [](Random& random) {
        const float size = magnitude(random, 1e-6f, 1e6f);
        const auto point = [&] { return random.vec3(-size, size); };
        const Triangle triangle { point(), point(), point() };
        return TrianglePoint { triangle, point() };
    }));

    const Stress collapsed("interpolate.barycentric.collapsed", sum,
        constructed<TrianglePoint>({
            { "a point", { { glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(1.0f) }, glm::vec3(2.0f) } },
            { "the origin", { { glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f) }, glm::vec3(0.0f) } },
        }));

}
}
