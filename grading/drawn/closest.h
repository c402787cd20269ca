#pragma once
#include "scene.h"

// Points of lights.
namespace grading {

// That of a light which lies closest to a point (of a parallelogram with unequal angles, about so).
[[nodiscard]] glm::vec3 closestOnLight(const Scene::SceneLight& light, const glm::vec3& point);

// Whether a ray without an end meets it.
[[nodiscard]] bool pointsAt(const Ray& ray, const Scene::SceneLight& light);

}
