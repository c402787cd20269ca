#include "debug/recording.h"
#include "draw.h"

void drawSphere(const glm::vec3& center, float radius, const glm::vec3& color)
{
    if (debug::Recording::isOpen())
        debug::Recording::add(debug::DrawnSphere { center, radius, color });
}

void drawSphere(const Sphere& sphere)
{
    drawSphere(sphere.center, sphere.radius, sphere.material.kd);
}
