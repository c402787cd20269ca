#include "extra.h"
#include "recursive.h"

void renderRayGlossyComponent(RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth)
{
    renderRaySpecularComponent(state, ray, hitInfo, hitColor, rayDepth);
}
