// Weak: this object comes with all of its functions, and a submission may define only some of them.
#include "recursive.h"
#include "not_written_yet.h"

[[gnu::weak]] Ray generateReflectionRay(Ray ray, HitInfo)
{
    notWrittenYet("generateReflectionRay");
    return ray;
}

[[gnu::weak]] Ray generatePassthroughRay(Ray ray, HitInfo)
{
    notWrittenYet("generatePassthroughRay");
    return ray;
}

[[gnu::weak]] void renderRaySpecularComponent(RenderState&, Ray, const HitInfo&, glm::vec3&, int)
{
    notWrittenYet("renderRaySpecularComponent");
}

[[gnu::weak]] void renderRayTransparentComponent(RenderState&, Ray, const HitInfo&, glm::vec3&, int)
{
    notWrittenYet("renderRayTransparentComponent");
}
