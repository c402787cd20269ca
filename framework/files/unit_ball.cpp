#include "files/unit_ball.h"
#include <algorithm>
#include <glm/geometric.hpp>

namespace files {
namespace {

    template <typename Function> void forEachPosition(std::span<Mesh> meshes, const Function& function)
    {
        for (Mesh& mesh : meshes)
            for (Vertex& vertex : mesh.vertices)
                function(vertex.position);
    }

}

void fitIntoUnitBall(std::span<Mesh> meshes)
{
    glm::dvec3 sum { 0.0 }; // a float would lose the small among a million vertices
    double count = 0.0;
    forEachPosition(meshes, [&](const glm::vec3& position) {
        sum += glm::dvec3(position);
        count += 1.0;
    });
    const glm::dvec3 mean = sum / std::max(count, 1.0);

    double largest = 0.0;
    forEachPosition(meshes,
        [&](const glm::vec3& position) { largest = std::max(largest, glm::distance(glm::dvec3(position), mean)); });
    const double scale = largest > 0.0 ? 1.0 / largest : 1.0; // of a single point there is nothing to scale

    forEachPosition(meshes, [&](glm::vec3& position) { position = (glm::dvec3(position) - mean) * scale; });
}

}
