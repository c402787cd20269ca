#include "draw.h"

void drawScene(const Scene& scene)
{
    for (const Mesh& mesh : scene.meshes)
        drawMesh(mesh);
    for (const Sphere& sphere : scene.spheres)
        drawSphere(sphere);
}
