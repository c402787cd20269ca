#include <cmath>
#include <framework/trackball.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

Trackball::Trackball(float fieldOfView, float distanceFromLookAt, float aspectRatio)
    : m_tanHalfFieldOfView(std::tan(fieldOfView / 2.0f))
    , m_aspectRatio(aspectRatio)
{
    setCamera(m_lookAt, m_rotation, distanceFromLookAt);
}

void Trackball::setCamera(const glm::vec3& lookAt, const glm::vec3& rotation, float distanceFromLookAt)
{
    m_lookAt = lookAt;
    m_rotation = rotation;
    m_distanceFromLookAt = distanceFromLookAt;
    m_cameraToWorld = glm::mat3_cast(glm::quat(rotation));
    m_position = lookAt - distanceFromLookAt * forward();
}

void Trackball::setAspectRatio(float aspectRatio)
{
    m_aspectRatio = aspectRatio;
}

Ray Trackball::generateRay(const glm::vec2& ndc) const
{
    // The first axis points left, the screen's x points right.
    const glm::vec3 inCamera { -ndc.x * m_aspectRatio * m_tanHalfFieldOfView, ndc.y * m_tanHalfFieldOfView, 1.0f };
    return { .origin = m_position, .direction = m_cameraToWorld * glm::normalize(inCamera) };
}
