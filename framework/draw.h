#pragma once
#include "common.h"
#include "scene.h"
#include <framework/mesh.h>
#include <framework/ray.h>

// Provided: drawing for debugging. Calls record what they are given where somebody is listening on this thread (the
// window, a report, a grader) and cost next to nothing where nobody is. Colours in [0, 1].
inline void drawRay(const Ray& ray, const glm::vec3& color = glm::vec3(1.0f));
void drawAABB(const AxisAlignedBox& box, DrawMode drawMode = DrawMode::Filled, const glm::vec3& color = glm::vec3(1.0f),
    float transparency = 1.0f);
void drawTriangle(const Vertex& v0, const Vertex& v1, const Vertex& v2);
void drawSphere(const glm::vec3& center, float radius, const glm::vec3& color = glm::vec3(1.0f));
void drawSphere(const Sphere& sphere);
void drawMesh(const Mesh& mesh);
void drawScene(const Scene& scene);

namespace drawing {
inline constinit thread_local int numListeners = 0; // to what this thread draws
void recordRay(const Ray& ray, const glm::vec3& color);
}

// Here, so that the ray is not even put together where nobody listens: some are drawn for every sample of a light.
inline void drawRay(const Ray& ray, const glm::vec3& color)
{
    if (drawing::numListeners > 0) [[unlikely]]
        drawing::recordRay(ray, color);
}
