#include "grading/check.h"
#include "grading/expect.h"
#include "grading/picture.h"
#include "grading/probes/interpolation.h"
#include <fmt/format.h>

// Means weighted by barycentric coordinates.
namespace grading::interpolate_mean {
namespace {

    // Barycentric coordinates: of the corners and of points on the edges first, then of any point.
    glm::vec3 weightsOf(Random& random, int i)
    {
        const glm::vec2 uv = random.vec2();
        const glm::vec2 inside = uv.x + uv.y > 1.0f ? 1.0f - uv : uv;
        glm::vec3 weights { 1.0f - inside.x - inside.y, inside };
        if (i < 6) {
            weights = glm::vec3(0.0f);
            weights[i % 3] = i < 3 ? 1.0f : uv.x;
            weights[(i + 1) % 3] = 1.0f - weights[i % 3];
        }
        return weights;
    }

    // Unit normals up to 60 degrees from one in the middle: their mean is 0.5 long or more, and a rounding counts
    // twice.
    std::vector<Weighted<glm::vec3>> someNormals(Random& random)
    {
        std::vector<Weighted<glm::vec3>> means;
        for (int i = 0; i < 100; ++i) {
            const glm::vec3 middle = random.direction();
            const auto normal = [&] {
                for (;;)
                    if (const glm::vec3 n = random.direction(); glm::dot(n, middle) > 0.5f)
                        return n;
            };
            means.push_back({ normal(), normal(), normal(), weightsOf(random, i) });
        }
        return means;
    }

    template <typename V, typename Judge>
    void judgeMeans(Exam& exam, const std::string& probe, const std::string& function,
        const std::vector<Weighted<V>>& means, const Judge& judge)
    {
        const auto results = exam.ask<std::vector<V>>(probe, means);
        expectCount(function, results.size(), means.size());
        for (std::size_t i = 0; i < results.size(); ++i) {
            const auto& [a, b, c, weights] = means[i];
            judge(fmt::format("{} of {}, {}, {} at {}", function, toText(a), toText(b), toText(c), toText(weights)),
                means[i], results[i]);
        }
    }

    template <typename V> auto meanOracle(const Weighted<V>& mean)
    {
        using D = glm::vec<V::length(), double>;
        const glm::dvec3 w { mean.weights };
        return w.x * D(mean.a) + w.y * D(mean.b) + w.z * D(mean.c);
    }

    // The length is left to another check.
    void compareNormalDirection(Exam& exam)
    {
        judgeMeans(exam, "interpolate.normal", "interpolateNormal", someNormals(exam.random),
            [](const std::string& asked, const Weighted<glm::vec3>& mean, const glm::vec3& came) {
                const glm::vec3 direction { glm::normalize(glm::dvec3(came)) }; // NaN for a zero vector
                expectNear("the direction of " + asked, direction, glm::normalize(meanOracle(mean)), fewRoundings);
            });
    }

    void compareNormalLength(Exam& exam)
    {
        judgeMeans(exam, "interpolate.normal", "interpolateNormal", someNormals(exam.random),
            [](const std::string& asked, const Weighted<glm::vec3>&, const glm::vec3& came) {
                expectNear("the length of " + asked, glm::length(came), 1.0, fewRoundings);
            });
    }

    void compareTexCoords(Exam& exam, float lower, float upper)
    {
        std::vector<Weighted<glm::vec2>> means;
        for (int i = 0; i < 100; ++i)
            means.push_back({ exam.random.vec2(lower, upper), exam.random.vec2(lower, upper),
                exam.random.vec2(lower, upper), weightsOf(exam.random, i) });
        judgeMeans(exam, "interpolate.texCoord", "interpolateTexCoord", means,
            [&](const std::string& asked, const Weighted<glm::vec2>& mean, const glm::vec2& came) {
                expectNear(asked, came, meanOracle(mean), fewRoundings * std::max(1.0f, upper));
            });
    }

    const Check normalDirection("interpolation.normal.direction", 1.0,
        "alpha weighs the normal of v0, beta that of v1, gamma that of v2", compareNormalDirection);
    const Check normalUnit("interpolation.normal.unit", 1.0,
        "a mean of unit vectors is shorter than 1: return glm::normalize of it", compareNormalLength);
    const Check texCoordWeights("interpolation.texcoord.weights", 0.5,
        "alpha weighs the coordinates of v0, beta those of v1, gamma those of v2",
        [](Exam& exam) { compareTexCoords(exam, 0.0f, 1.0f); });
    const Check texCoordRange("interpolation.texcoord.range", 0.5,
        "coordinates below 0 and above 1 stay as they are: what they mean is up to the texture's lookup",
        [](Exam& exam) { compareTexCoords(exam, -8.0f, 8.0f); });
    const Check picture("interpolation.picture.normals", 1.0, "see the other checks of interpolation",
        [](Exam& exam) { comparePicture(exam, pictureOf("normal_interpolation")); });

}
}
