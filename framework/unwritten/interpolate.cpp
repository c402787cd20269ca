// Weak: this object comes with all of its functions, and a submission may define only some of them.
#include "interpolate.h"
#include "not_written_yet.h"

[[gnu::weak]] glm::vec3 computeBarycentricCoord(const glm::vec3&, const glm::vec3&, const glm::vec3&, const glm::vec3&)
{
    notWrittenYet("computeBarycentricCoord");
    return glm::vec3(1.0f / 3.0f);
}

[[gnu::weak]] glm::vec3 interpolateNormal(const glm::vec3& n0, const glm::vec3&, const glm::vec3&, const glm::vec3)
{
    notWrittenYet("interpolateNormal");
    return n0;
}

[[gnu::weak]] glm::vec2 interpolateTexCoord(const glm::vec2& t0, const glm::vec2&, const glm::vec2&, const glm::vec3)
{
    notWrittenYet("interpolateTexCoord");
    return t0;
}
