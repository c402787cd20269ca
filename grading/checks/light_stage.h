#pragma once
#include "grading/exam.h"
#include "grading/probes/light_sample.h"
#include "grading/probes/stage.h"

// Shaded points, lights above them, and what stands in between.
namespace grading {

// A point of a surface with some opaque material, seen from its front; shading and shadows are on.
[[nodiscard]] Stage randomStage(Random& random);

// Makes the view ray's direction some other length than 1, about 4 or 1/4; the shaded point stays.
void stretch(Stage& stage, Random& random);

// Around the shaded point: a large triangle, or a sphere.
void addSurface(Stage& stage, Random& random, bool isSphere);

// Where a light is in front of the surface, at least as steep as the cosine says.
[[nodiscard]] glm::vec3 lightPosition(Random& random, const Stage& stage, float distance, float minCosine = 0.3f);

// A triangle in the line from the shaded point to the light, or behind it: fraction 0 is the point, 1 the light.
void addPane(Stage& stage, Random& random, const glm::vec3& light, double fraction, const Material& material);

// A triangle around a point, across the normal.
void addTriangleAround(
    Scene& scene, const glm::dvec3& center, const glm::vec3& normal, float radius, const Material& material);

// Some material with this alpha.
[[nodiscard]] Material glass(Random& random, float alpha);

// How far apart surfaces, points and lights stand that are close to each other. Shadow rays may start and end up to
// 1e-3 beside them.
[[nodiscard]] float smallGap(Random& random);

// For messages: where the shaded point is and how far the light.
[[nodiscard]] std::string describe(const Stage& stage, const glm::vec3& light);

}
