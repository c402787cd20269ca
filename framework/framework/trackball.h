#pragma once
#include "ray.h"
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// A pinhole camera that orbits a point.
class Trackball {
public:
    // fieldOfView: vertical, radians, in (0, pi); aspectRatio: width over height.
    explicit Trackball(float fieldOfView = 0.87f, float distanceFromLookAt = 1.0f, float aspectRatio = 1.0f);

    // rotation: Euler angles in radians about x, y, z.
    void setCamera(const glm::vec3& lookAt, const glm::vec3& rotation, float distanceFromLookAt);
    void setAspectRatio(float aspectRatio);

    [[nodiscard]] glm::vec3 position() const { return m_position; }
    [[nodiscard]] glm::vec3 lookAt() const { return m_lookAt; }
    [[nodiscard]] glm::vec3 forward() const { return m_cameraToWorld[2]; }
    [[nodiscard]] glm::vec3 up() const { return m_cameraToWorld[1]; }
    [[nodiscard]] glm::vec3 left() const { return m_cameraToWorld[0]; }
    [[nodiscard]] glm::vec3 rotationEulerAngles() const { return m_rotation; }
    [[nodiscard]] float distanceFromLookAt() const { return m_distanceFromLookAt; }

    // The unit ray through a point of the screen; ndc: (-1, -1) bottom left to (1, 1) top right.
    [[nodiscard]] Ray generateRay(const glm::vec2& ndc) const;

private:
    float m_tanHalfFieldOfView;
    float m_aspectRatio;
    float m_distanceFromLookAt;
    glm::vec3 m_lookAt { 0.0f };
    glm::vec3 m_rotation { 0.0f };
    glm::vec3 m_position;
    glm::mat3 m_cameraToWorld { 1.0f }; // columns: left, up, forward
};
