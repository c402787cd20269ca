#include "debug/recording.h"
#include "draw.h"

void drawMesh(const Mesh& mesh)
{
    if (!debug::Recording::isOpen())
        return;
    for (const glm::uvec3& t : mesh.triangles)
        drawTriangle(mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]);
}
