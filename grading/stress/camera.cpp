#include "grading/stress/probes/cameras.h"
#include "grading/stress/rounding.h"
#include "grading/stress/stress.h"
#include <cfloat>
#include <glm/mat3x3.hpp>
#include <numbers>

// The library's camera, turned by angles about x, then y, then z.
namespace stress::camera {
namespace {

    using Real = long double;
    using Vector = glm::vec<3, Real>;
    using Matrix = glm::mat<3, 3, Real>;

    std::string describe(const CameraPoint& query)
    {
        return fmt::format("a camera with a field of view of {}, aspect ratio {}, {} away from {}, turned by {}, at {}",
            exactly(query.fieldOfView), exactly(query.aspectRatio), exactly(query.distance), exactly(query.lookAt),
            exactly(query.rotation), exactly(query.ndc));
    }

    // About one axis, by the right-hand rule.
    Matrix turned(int axis, float angle)
    {
        const Real c = std::cos(static_cast<Real>(angle)), s = std::sin(static_cast<Real>(angle));
        Matrix matrix { 1 };
        const int y = (axis + 1) % 3, z = (axis + 2) % 3;
        matrix[y][y] = matrix[z][z] = c;
        matrix[y][z] = s;
        matrix[z][y] = -s;
        return matrix;
    }

    Judgement judge(const CameraPoint& query, const Ray& came)
    {
        const Matrix toWorld = turned(2, query.rotation.z) * turned(1, query.rotation.y) * turned(0, query.rotation.x);
        const Real height = std::tan(static_cast<Real>(query.fieldOfView) / 2);
        const Real width = height * static_cast<Real>(query.aspectRatio);
        const Vector inCamera { -static_cast<Real>(query.ndc.x) * width, static_cast<Real>(query.ndc.y) * height, 1 };
        const Vector direction = toWorld * glm::normalize(inCamera);
        const auto distance = static_cast<Real>(query.distance);
        const Vector origin = Vector(query.lookAt) - distance * toWorld[2];

        // Six half angles are made a quaternion, and that a matrix: some ten roundings for each entry.
        constexpr double ofMatrix = 8.0;
        const Judgement judgement = judgeUlps(came.direction, glm::dvec3(direction), glm::dvec3(1.0), ofMatrix);
        if (!judgement.isRight)
            return judgement;
        const double ofUnit = std::abs(glm::length(glm::dvec3(came.direction)) - 1.0) / ulpOfOne;
        if (!(ofUnit <= ofMatrix))
            return wrong(exactly(came.direction), "a unit vector", ofUnit);
        if (came.t != FLT_MAX)
            return wrong(exactly(came.t), "t = FLT_MAX");
        return judgeUlps(came.origin, glm::dvec3(origin),
            glm::abs(glm::dvec3(query.lookAt)) + std::abs(static_cast<double>(query.distance)), ofMatrix);
    }

    const Question<CameraPoint, Ray> camera { "stress.camera", describe, judge };

    constexpr float lastBelowPi = 0x1.921fb4p1f;
    constexpr float quarter = std::numbers::pi_v<float> / 2.0f;

    float anyFieldOfView(Random& random)
    {
        switch (random.integer(0, 3)) {
        case 0:
            return magnitude(random, 1e-30f, 1.0f);
        case 1:
            return lastBelowPi - magnitude(random, 1e-7f, 1.0f);
        default:
            return random.uniform(0.1f, 3.0f);
        }
    }

    glm::vec3 anyRotation(Random& random)
    {
        if (random.integer(0, 3) == 0)
            return quarter * glm::vec3(random.integer(-4, 4), random.integer(-4, 4), random.integer(-4, 4));
        return random.vec3(-7.0f, 7.0f);
    }

    CameraPoint anyPoint(Random& random)
    {
        CameraPoint query {};
        query.fieldOfView = anyFieldOfView(random);
        query.aspectRatio = magnitude(random, 1e-4f, 1e4f);
        query.distance = magnitude(random, 1e-6f, 1e6f);
        query.lookAt = magnitude(random, 1e-6f, 1e6f) * random.vec3(-1.0f, 1.0f);
        query.rotation = anyRotation(random);
        query.ndc = random.integer(0, 3) == 0 ? glm::vec2(random.integer(-1, 1), random.integer(-1, 1))
                                              : random.vec2(-1.0f, 1.0f);
        return query;
    }

    const Stress anywhere("camera.ray.anywhere", camera, randomly<CameraPoint>(500'000, anyPoint));

    CameraPoint seen(float fieldOfView, float aspectRatio, const glm::vec2& ndc, float distance = 3.0f,
        const glm::vec3& rotation = { 0.3f, -0.7f, 0.2f }, const glm::vec3& lookAt = glm::vec3(0.0f))
    {
        return { fieldOfView, aspectRatio, distance, lookAt, rotation, ndc };
    }

    constexpr glm::vec2 corner { 1.0f, -1.0f }, centre { 0.0f };

    const Stress special("camera.ray.special", camera,
        constructed<CameraPoint>({
            { "the least field of view", seen(FLT_MIN, 1.0f, corner) },
            { "a field of view of 1e-6", seen(1e-6f, 1.0f, corner) },
            { "the largest field of view, corner", seen(lastBelowPi, 1.0f, corner) },
            { "the largest field of view, centre", seen(lastBelowPi, 1.0f, centre) },
            { "the largest field of view, beside the centre", seen(lastBelowPi, 1.0f, glm::vec2(1e-7f)) },
            { "the largest field of view, 10,000 to 1", seen(lastBelowPi, 1e4f, corner) },
            { "10,000 to 1, corner", seen(1.0f, 1e4f, corner) },
            { "10,000 to 1, centre", seen(1.0f, 1e4f, centre) },
            { "1 to 10,000, corner", seen(1.0f, 1e-4f, corner) },
            { "straight down", seen(1.0f, 1.0f, corner, 3.0f, { quarter, 0.0f, 0.0f }) },
            { "straight up", seen(1.0f, 1.0f, corner, 3.0f, { -quarter, 0.0f, 0.0f }) },
            { "turned round", seen(1.0f, 1.0f, corner, 3.0f, { 0.0f, 2.0f * quarter, 0.0f }) },
            { "turned round a hundred times", seen(1.0f, 1.0f, corner, 3.0f, glm::vec3(400.0f * quarter)) },
            { "where it looks", seen(1.0f, 1.0f, corner, 0.0f) },
            { "1e-6 from where it looks", seen(1.0f, 1.0f, corner, 1e-6f, {}, glm::vec3(1.0f)) },
            { "1e6 from where it looks", seen(1.0f, 1.0f, corner, 1e6f, {}, glm::vec3(1e-3f)) },
            { "looking at what is 1e6 away", seen(1.0f, 1.0f, corner, 3.0f, {}, glm::vec3(1e6f)) },
        }));

}
}
