#include "gui/clip_matrix.h"
#include "some_camera.h"
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <random>

namespace {

// A float of about 1 has been rounded some ten times: the corners of the picture, a product, a quotient.
constexpr float roundings = 1e-5f;

glm::vec3 toNdc(const glm::mat4& toClip, const Trackball& camera, const glm::vec3& position)
{
    const glm::vec4 clip = toClip * glm::vec4(position - camera.position(), 1.0f);
    return glm::vec3(clip) / clip.w;
}

}

TEST_CASE("What a camera's ray meets is drawn where the ray goes through the picture", "[gui]")
{
    const Trackball camera = someCamera();
    const glm::mat4 toClip = gui::clipMatrix(camera, { 0.5f, 20.0f });
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec2 place { unit(random), unit(random) };
        const Ray ray = camera.generateRay(place);
        const glm::vec3 shown = toNdc(toClip, camera, ray.origin + (5.0f + 4.0f * unit(random)) * ray.direction);
        CHECK(glm::distance(glm::vec2(shown), place) < roundings);
    }
}

TEST_CASE("Depth goes from -1 at the nearest distance to 1 at the farthest, wherever in the picture", "[gui]")
{
    const Trackball camera = someCamera();
    const gui::DepthRange range { 0.5f, 20.0f };
    const glm::mat4 toClip = gui::clipMatrix(camera, range);
    for (const float x : { -1.0f, 0.0f, 0.7f }) {
        const Ray ray = camera.generateRay({ x, -x });
        const auto depthAt = [&](float distance) {
            const float t = distance / glm::dot(ray.direction, camera.forward());
            return toNdc(toClip, camera, ray.origin + t * ray.direction).z;
        };
        CHECK(depthAt(range.nearest) == Approx(-1.0f).margin(roundings));
        CHECK(depthAt(range.farthest) == Approx(1.0f).margin(roundings));
        for (float distance = range.nearest; distance < range.farthest; distance *= 1.1f)
            CHECK(depthAt(distance) < depthAt(1.1f * distance));
    }
}

TEST_CASE("The range of depths has all of a ball that lies ahead, and begins in front of the camera", "[gui]")
{
    const Trackball camera = someCamera();
    for (const float distance : { -2.0f, 0.0f, 1.0f, 5.0f }) {
        const auto [nearest, farthest]
            = gui::depthRange(camera, camera.position() + distance * camera.forward() + camera.up(), 1.5f);
        CHECK(nearest > 0.0f);
        CHECK(farthest > nearest);
        CHECK(nearest <= std::max(distance - 1.5f, 0.01f) + roundings);
        CHECK(farthest >= distance + 1.5f - roundings);
    }
}
