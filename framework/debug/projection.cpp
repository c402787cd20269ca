#include "debug/projection.h"
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace debug {

static constexpr float nearest = 1e-3f; // distance from the camera's plane

// The ray to a corner says what the camera keeps to itself.
Projection::Projection(const Trackball& camera, glm::ivec2 size)
    : m_camera(camera)
    , m_size(size)
{
    const glm::vec3 corner = camera.generateRay({ 1.0f, 1.0f }).direction;
    m_extent = glm::vec2(-glm::dot(corner, camera.left()), glm::dot(corner, camera.up()))
        / glm::dot(corner, camera.forward());
}

glm::vec3 Projection::toCamera(const glm::vec3& position) const
{
    const glm::vec3 d = position - m_camera.position();
    return { glm::dot(d, m_camera.left()), glm::dot(d, m_camera.up()), glm::dot(d, m_camera.forward()) };
}

glm::vec2 Projection::toPixel(const glm::vec3& inCamera) const
{
    const glm::vec2 ndc = glm::vec2(-inCamera.x, inCamera.y) / (inCamera.z * m_extent);
    return (0.5f * ndc + 0.5f) * m_size;
}

std::optional<glm::vec2> Projection::point(const glm::vec3& position) const
{
    const glm::vec3 inCamera = toCamera(position);
    return inCamera.z < nearest ? std::nullopt : std::optional(toPixel(inCamera));
}

std::optional<std::pair<glm::vec2, glm::vec2>> Projection::line(const glm::vec3& a, const glm::vec3& b) const
{
    glm::vec3 from = toCamera(a), to = toCamera(b);
    if (from.z < nearest && to.z < nearest)
        return std::nullopt;
    const glm::vec3 crossing = from + (nearest - from.z) / (to.z - from.z) * (to - from);
    if (from.z < nearest)
        from = crossing;
    if (to.z < nearest)
        to = crossing;
    return std::pair(toPixel(from), toPixel(to));
}

std::vector<glm::vec2> Projection::ball(const glm::vec3& center, float radius) const
{
    constexpr int corners = 24;
    std::vector<glm::vec2> outline;
    const glm::vec3 inCamera = toCamera(center);
    if (inCamera.z < nearest)
        return outline;
    for (int i = 0; i < corners; ++i) {
        const float angle = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(corners);
        outline.push_back(toPixel(inCamera + radius * glm::vec3(glm::cos(angle), glm::sin(angle), 0.0f)));
    }
    return outline;
}

}
