// Weak: this object comes with all of its functions, and a submission may define only some of them.
#include "shading.h"
#include "not_written_yet.h"

[[gnu::weak]] glm::vec3 LinearGradient::sample(float) const
{
    notWrittenYet("LinearGradient::sample");
    return glm::vec3(0.0f);
}

[[gnu::weak]] glm::vec3 computeLinearGradientModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo, const LinearGradient&)
{
    notWrittenYet("computeLinearGradientModel");
    return computeLambertianModel(state, cameraDirection, lightDirection, lightColor, hitInfo, hitInfo.material.kd);
}

[[gnu::weak]] glm::vec3 computeLinearGradientModelComparison(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo, const LinearGradient&)
{
    notWrittenYet("computeLinearGradientModelComparison");
    return computeLambertianModel(state, cameraDirection, lightDirection, lightColor, hitInfo, hitInfo.material.kd);
}
