#include "config.h"
#include <catch2/catch.hpp>
#include <framework/trackball.h>
#include <glm/gtc/constants.hpp>

namespace {

constexpr double fewRoundings = 1e-6;

// A vector turned about x, then y, then z, right-handed.
glm::dvec3 turned(glm::dvec3 v, const glm::dvec3& angles)
{
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, w = (axis + 2) % 3;
        const double c = std::cos(angles[axis]), s = std::sin(angles[axis]);
        const double along = v[u], across = v[w];
        v[u] = c * along - s * across;
        v[w] = s * along + c * across;
    }
    return v;
}

struct Placement {
    float fieldOfView, distance, aspectRatio;
    glm::vec3 lookAt, rotation;

    [[nodiscard]] Trackball camera() const
    {
        Trackball camera(fieldOfView, 1.0f, aspectRatio);
        camera.setCamera(lookAt, rotation, distance);
        return camera;
    }
};

const std::vector<Placement> placements {
    { 0.87f, 1.0f, 1.0f, { 0, 0, 0 }, { 0, 0, 0 } },
    { 0.5f, 3.0f, 4.0f / 3.0f, { 1, 2, -3 }, { 0.3f, 0.0f, 0.0f } },
    { 1.5f, 0.2f, 0.5f, { -1, 0, 2 }, { 0.0f, 2.0f, 0.0f } },
    { 0.87f, 10.0f, 2.0f, { 0, 1, 0 }, { 0.0f, 0.0f, -1.2f } },
    { 2.8f, 2.0f, 1.7f, { 0.5f, 0.25f, 3 }, { 0.4f, -2.5f, 0.7f } },
};

const std::vector<glm::vec2> screenPoints { { 0, 0 }, { -1, -1 }, { 1, -1 }, { -1, 1 }, { 1, 1 }, { 0.3f, -0.7f } };

}

TEST_CASE("Camera rays follow the formula", "[trackball]")
{
    for (const Placement& p : placements) {
        const Trackball camera = p.camera();
        const double tangent = std::tan(static_cast<double>(p.fieldOfView) / 2.0);
        const glm::dvec3 rotation { p.rotation };
        const glm::dvec3 position
            = glm::dvec3(p.lookAt) - static_cast<double>(p.distance) * turned({ 0, 0, 1 }, rotation);
        for (const glm::vec2& point : screenPoints) {
            const glm::dvec2 ndc { point };
            const glm::dvec3 inCamera { -ndc.x * static_cast<double>(p.aspectRatio) * tangent, ndc.y * tangent, 1.0 };
            const Ray ray = camera.generateRay(point);
            CHECK(glm::distance(glm::dvec3(ray.direction), turned(glm::normalize(inCamera), rotation)) < fewRoundings);
            CHECK(glm::distance(glm::dvec3(ray.origin), position) < 1e-5); // of numbers up to 10
            CHECK(ray.origin == camera.position());
            CHECK(ray.t == FLT_MAX);
        }
    }
}

TEST_CASE("The middle of the screen looks forward, at lookAt", "[trackball]")
{
    for (const Placement& p : placements) {
        const Trackball camera = p.camera();
        CHECK(glm::distance(camera.generateRay({ 0, 0 }).direction, camera.forward()) < 1e-6f);
        CHECK(glm::distance(camera.position() + p.distance * camera.forward(), p.lookAt) < 1e-5f);
        CHECK(camera.lookAt() == p.lookAt);
        CHECK(camera.rotationEulerAngles() == p.rotation);
        CHECK(camera.distanceFromLookAt() == p.distance);
    }
}

TEST_CASE("The upper edge of the screen is up, the right edge opposite left, half a field of view away", "[trackball]")
{
    for (const Placement& p : placements) {
        const Trackball camera = p.camera();
        const auto dot = [](const glm::vec3& a, const glm::vec3& b) { return glm::dot(glm::dvec3(a), glm::dvec3(b)); };
        const glm::vec3 top = camera.generateRay({ 0, 1 }).direction, right = camera.generateRay({ 1, 0 }).direction;
        CHECK(dot(top, camera.up()) == Approx(std::sin(static_cast<double>(p.fieldOfView) / 2.0)));
        CHECK(dot(top, camera.left()) == Approx(0.0).margin(fewRoundings));
        CHECK(dot(right, camera.left()) < 0.0);
        CHECK(dot(right, camera.up()) == Approx(0.0).margin(fewRoundings));
        CHECK(dot(camera.up(), camera.left()) == Approx(0.0).margin(fewRoundings));
        CHECK(glm::distance(glm::cross(camera.left(), camera.up()), camera.forward()) < 1e-6f);
    }
}

TEST_CASE("A configuration's camera has its angles in degrees and the picture's aspect ratio", "[trackball]")
{
    Config config;
    config.camera
        = { .lookAt = { 1, 2, 3 }, .rotation = { 90, 0, 0 }, .distanceFromLookAt = 2.0f, .fieldOfView = 90.0f };
    config.size = { 200, 100 };
    const Trackball camera = makeTrackball(config);
    CHECK(glm::distance(camera.forward(), glm::vec3(0, -1, 0)) < 1e-6f); // z turned about x by a quarter
    CHECK(glm::distance(camera.position(), glm::vec3(1, 4, 3)) < 1e-6f);
    const glm::vec3 corner = camera.generateRay({ 1, 1 }).direction;
    CHECK(glm::distance(corner, glm::normalize(-2.0f * camera.left() + camera.up() + camera.forward())) < 1e-6f);
}
