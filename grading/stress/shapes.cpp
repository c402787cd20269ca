#include "grading/stress/shapes.h"

namespace stress {

Frame randomFrame(Random& random)
{
    const glm::vec3 up = random.direction();
    for (;;) {
        const glm::vec3 across = glm::cross(up, random.direction());
        if (glm::dot(across, across) > 0.1f)
            return { glm::cross(glm::normalize(across), up), glm::normalize(across), up };
    }
}

grading::Triangle triangleIn(const Frame& frame, Random& random, const Setting& setting)
{
    const glm::vec3 first = setting.size * random.uniform(0.0f, setting.farFromZero) * random.direction();
    const glm::vec3 edge = setting.size * frame.along;
    const glm::vec3 height = (setting.size / setting.slenderness) * frame.across;
    return { first, first + edge, first + random.uniform() * edge + height };
}

glm::vec3 weightsInside(Random& random)
{
    glm::vec2 uv = random.vec2();
    if (uv.x + uv.y > 1.0f)
        uv = 1.0f - uv;
    return { 1.0f - uv.x - uv.y, uv };
}

glm::vec3 weightsAround(Random& random)
{
    const glm::vec2 uv = random.vec2(-1.0f, 2.0f);
    return { 1.0f - uv.x - uv.y, uv };
}

Ray rayTo(const glm::vec3& point, const Frame& frame, Random& random, const Setting& setting)
{
    const float angle = random.uniform(0.0f, 6.2831853f);
    const glm::vec3 inPlane = std::cos(angle) * frame.along + std::sin(angle) * frame.across;
    const float side = random.uniform() < 0.5f ? -1.0f : 1.0f;
    const float cosine = std::sqrt(1.0f - setting.sine * setting.sine);
    const glm::vec3 direction = cosine * inPlane + side * setting.sine * frame.up;
    return { point - setting.size * setting.distance * direction, magnitude(random, 1e-3f, 1e3f) * direction };
}

}
