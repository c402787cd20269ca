#include "gui/clip_matrix.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace gui {

DepthRange depthRange(const Trackball& camera, const glm::vec3& center, float radius)
{
    constexpr float resolved = 1e-3f; // of the farthest: 24 bits of depth still tell 1 part in 16,000 apart there
    const float distance = glm::dot(center - camera.position(), camera.forward());
    const float farthest = std::max(distance + radius, 1e-6f);
    return { std::max(distance - radius, resolved * farthest), farthest };
}

glm::mat4 clipMatrix(const Trackball& camera, DepthRange range)
{
    // The ray to a corner says how much the camera sees at distance 1.
    const glm::vec3 corner = camera.generateRay({ 1.0f, 1.0f }).direction;
    const glm::vec3 atOne = corner / glm::dot(corner, camera.forward());
    const glm::vec3 x = camera.left() / glm::dot(atOne, camera.left());
    const glm::vec3 y = camera.up() / glm::dot(atOne, camera.up());
    // Depth from -1 at the nearest to 1 at the farthest, once divided by the distance.
    const auto [n, f] = range;
    const glm::vec4 z { (f + n) / (f - n) * camera.forward(), -2.0f * f * n / (f - n) };
    return glm::transpose(glm::mat4(glm::vec4(x, 0.0f), glm::vec4(y, 0.0f), z, glm::vec4(camera.forward(), 0.0f)));
}

}
