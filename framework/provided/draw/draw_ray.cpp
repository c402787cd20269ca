#include "debug/recording.h"
#include "draw.h"

void drawRay(const Ray& ray, const glm::vec3& color)
{
    if (debug::Recording::isOpen())
        debug::Recording::add(debug::DrawnRay { ray, color });
}
