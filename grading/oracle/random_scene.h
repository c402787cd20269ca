#pragma once
#include "grading/random.h"
#include "scene.h"
#include <array>

namespace grading {

// An opaque material with colours of its own.
[[nodiscard]] Material randomMaterial(Random& random);

// A triangle that is no sliver, centred in the box of +-1 around the centre. The vertex normals differ from the flat
// one by up to 20 degrees.
[[nodiscard]] std::array<Vertex, 3> randomTriangle(Random& random, const glm::vec3& center);

void addTriangle(Mesh& mesh, const std::array<Vertex, 3>& corners);

// Random triangles around the centre, in meshes of 25 or fewer, each with its own material.
void addTriangles(Scene& scene, Random& random, int count, const glm::vec3& center = glm::vec3(0.0f));

// Random spheres, radius 0.1 to 0.4, centred in the box of +-1.
void addSpheres(Scene& scene, Random& random, int count);

}
