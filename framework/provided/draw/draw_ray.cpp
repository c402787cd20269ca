#include "debug/recording.h"
#include "draw.h"

void drawing::recordRay(const Ray& ray, const glm::vec3& color)
{
    debug::Recording::add(debug::DrawnRay { ray, color });
}
