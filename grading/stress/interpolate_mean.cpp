#include "grading/probes/interpolation.h"
#include "grading/stress/oracle/crossing.h"
#include "grading/stress/shapes.h"
#include "grading/stress/stress.h"
#include "grading/stress/text.h"

namespace stress::interpolate_mean {
namespace {

    using Normals = grading::Weighted<glm::vec3>;
    using TexCoords = grading::Weighted<glm::vec2>;

    template <typename Mean> std::string describe(const Mean& mean)
    {
        return fmt::format("the mean of {}, {}, {} by the weights {}", exactly(mean.a), exactly(mean.b),
            exactly(mean.c), exactly(mean.weights));
    }

    struct Sum {
        glm::dvec3 value;
        double magnitude; // of what was added: three products, with three roundings each
    };

    Sum sumOf(const Normals& mean)
    {
        const glm::dvec3 a = mean.a, b = mean.b, c = mean.c, weights = glm::abs(glm::dvec3(mean.weights));
        const glm::dvec3 sum = static_cast<double>(mean.weights.x) * a + static_cast<double>(mean.weights.y) * b
            + static_cast<double>(mean.weights.z) * c;
        return { sum, weights.x * glm::length(a) + weights.y * glm::length(b) + weights.z * glm::length(c) };
    }

    // A unit vector along the sum, as far as roundings leave it a direction; where they do not, or the sum's square is
    // too small for a float, any unit vector, zero, or one of the three as it is.
    Judgement judgeNormal(const Normals& mean, const glm::vec3& came)
    {
        const auto [value, magnitude] = sumOf(mean);
        const double length = glm::length(value), condition = magnitude / length;
        const glm::dvec3 normal { came };
        const double off = std::abs(glm::length(normal) - 1.0);
        const bool isUnit = off <= 4.0 * rounding;
        constexpr double leastLength = 0x1p-58; // whose square still has all its digits, added to two of its like
        const bool hasDirection = length >= leastLength && 8.0 * rounding * condition < 0.5;
        const double error = glm::distance(normal, value / length), ulps = error / (2.0 * rounding * condition);
        const bool isRight = hasDirection
            ? isUnit && error <= 8.0 * rounding * (condition + 1.0)
            : isUnit || came == glm::vec3(0.0f) || came == mean.a || came == mean.b || came == mean.c;
        if (isRight)
            return right(hasDirection ? ulps : 0.0);
        return wrong(exactly(came),
            hasDirection ? "the unit vector " + exactly(value / length) : "a unit vector, zero, or one of the three",
            ulps);
    }

    // A weighted sum: three products, with three roundings each at most.
    Judgement judgeTexCoord(const TexCoords& mean, const glm::vec2& came)
    {
        const auto lift = [](const glm::vec2& v) { return glm::vec3(v, 0.0f); };
        const Normals lifted { lift(mean.a), lift(mean.b), lift(mean.c), mean.weights };
        const auto [value, magnitude] = sumOf(lifted);
        const double error = glm::distance(glm::dvec2(came), glm::dvec2(value));
        const double ulps = magnitude > 0.0 ? error / (2.0 * rounding * magnitude) : 0.0;
        if (error <= 4.0 * rounding * magnitude)
            return right(ulps);
        return wrong(exactly(came), exactly(glm::dvec2(value)), ulps);
    }

    const Question<Normals, glm::vec3> normal { "stress.normal", describe<Normals>, judgeNormal };
    const Question<TexCoords, glm::vec2> texCoord { "stress.texCoord", describe<TexCoords>, judgeTexCoord };

    const Stress normals("interpolate.normal.random", normal, randomly<Normals>(400'000, [](Random& random) {
        return Normals { random.direction(), random.direction(), random.direction(), weightsInside(random) };
    }));
    const Stress lengths("interpolate.normal.lengths", normal, randomly<Normals>(200'000, [](Random& random) {
        const auto vector = [&] { return magnitude(random, 1e-15f, 1e15f) * random.direction(); };
        return Normals { vector(), vector(), vector(), weightsInside(random) };
    }));
    // Nearly or quite cancelling.
    const Stress opposite("interpolate.normal.opposite", normal, randomly<Normals>(200'000, [](Random& random) {
        const glm::vec3 n = random.direction();
        const float noise = random.integer(0, 1) == 0 ? 0.0f : magnitude(random, 1e-7f, 1e-1f);
        const float weight = random.uniform(0.0f, 0.5f);
        return Normals { n, noise * random.direction() - n, random.direction(),
            { weight, weight, 1.0f - 2.0f * weight } };
    }));

    constexpr glm::vec3 up { 0, 0, 1 }, right_ { 1, 0, 0 }, half { 0.5f, 0.5f, 0.0f };

    const Stress specialNormals("interpolate.normal.special", normal,
        constructed<Normals>({
            { "all the same", { up, up, up, { 0.25f, 0.25f, 0.5f } } },
            { "all the same, a third each", { up, up, up, glm::vec3(1.0f / 3.0f) } },
            { "at corner 0", { up, right_, right_, { 1, 0, 0 } } },
            { "at corner 1", { right_, up, right_, { 0, 1, 0 } } },
            { "at corner 2", { right_, right_, up, { 0, 0, 1 } } },
            { "opposite", { up, -up, right_, half } },
            { "opposite, not in the middle", { up, -up, right_, { 0.75f, 0.25f, 0 } } },
            { "three that cancel", { { 1, 0, 0 }, { -0.5f, 0.75f, 0 }, { -0.5f, -0.75f, 0 }, glm::vec3(1.0f / 3.0f) } },
            { "zeros", { glm::vec3(0), glm::vec3(0), glm::vec3(0), half } },
            { "one zero", { glm::vec3(0), up, up, { 0.5f, 0.25f, 0.25f } } },
            { "a zero alone", { glm::vec3(0), up, up, { 1, 0, 0 } } },
            { "negative zeros", { glm::vec3(-0.0f), up, up, half } },
            { "tiny", { 1e-15f * up, 1e-15f * up, 1e-15f * right_, half } },
            { "denormal", { 1e-40f * up, 1e-40f * right_, 1e-40f * up, half } },
            { "a huge one and a tiny one", { 1e15f * up, 1e-15f * right_, up, half } },
            { "not unit", { 2.0f * up, 3.0f * right_, up, half } },
            { "no weights", { up, up, up, glm::vec3(0) } },
        }));

    const Stress texCoords("interpolate.tex_coord.random", texCoord, randomly<TexCoords>(400'000, [](Random& random) {
        const auto coordinates = [&] { return magnitude(random, 1e-6f, 1e9f) * random.vec2(-1.0f, 1.0f); };
        return TexCoords { coordinates(), coordinates(), coordinates(), weightsInside(random) };
    }));
    const Stress specialTexCoords("interpolate.tex_coord.special", texCoord,
        constructed<TexCoords>({
            { "at corner 0", { { 1, 2 }, { 3, 4 }, { 5, 6 }, { 1, 0, 0 } } },
            { "at corner 1", { { 1, 2 }, { 3, 4 }, { 5, 6 }, { 0, 1, 0 } } },
            { "at corner 2", { { 1, 2 }, { 3, 4 }, { 5, 6 }, { 0, 0, 1 } } },
            { "repeating", { { -1000, 1000 }, { 1000, -1000 }, { 0, 0 }, half } },
            { "huge", { glm::vec2(1e9f), glm::vec2(1e9f), glm::vec2(1e9f), { 0.25f, 0.25f, 0.5f } } },
            { "cancelling", { { 1, -1 }, { -1, 1 }, { 0, 0 }, half } },
            { "no weights", { { 1, 2 }, { 3, 4 }, { 5, 6 }, glm::vec3(0) } },
        }));

}
}
