// Shading by a colour gradient: the cosine between light and normal picks the colour.
//
// To read: Marschner and Shirley, "Fundamentals of Computer Graphics", chapter "Surface Shading"; Gooch et al. 1998,
// "A Non-Photorealistic Lighting Model for Automatic Technical Illustration". Provided, declared in shading.h:
// computeShading (which calls what is below), sampleMaterialKd, the models of Lambert, Phong and Blinn-Phong.
#include "shading.h"
#include "not_written_yet.h"

#pragma GCC diagnostic ignored "-Wunused-parameter" // delete this line when the whole file is written

// The colour at ti in [-1, 1]. Between the two components around ti, at t0 <= ti <= t1, it is
// (1 - w) * color0 + w * color1 with w = (ti - t0) / (t1 - t0).
//
// - The components come in any order, and this function may not change them.
// - Below the first and above the last component there is only one neighbour: take its colour.
// - Two components may have the same t. What is w then?
// - Without components the colour is black.
glm::vec3 LinearGradient::sample(float ti) const
{
    notWrittenYet("LinearGradient::sample"); // delete this line when the function is written
    return glm::vec3(0.0f);
}

// lightColor * gradient.sample(cosine), the cosine of the angle between lightDirection and the normal, in [-1, 1].
//
// - Both vectors are unit, but only up to rounding: their dot product can be 1.0000001.
// - A negative cosine is what the gradient's lower half is for.
// - The gradient takes the place of kd.
glm::vec3 computeLinearGradientModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    notWrittenYet("computeLinearGradientModel"); // delete this line when the function is written
    return computeLambertianModel(state, cameraDirection, lightDirection, lightColor, hitInfo, hitInfo.material.kd);
}

// A picture of where Phong and Blinn-Phong differ: the gradient's colour for the difference of the specular terms,
// max(dot(r, v), 0)^shininess and max(dot(n, h), 0)^shininess, where r is lightDirection mirrored about the normal n,
// v is cameraDirection and h the unit vector halfway between light and camera. One half of the gradient belongs to
// Phong, the other to Blinn-Phong, 0 to neither.
//
// - The sign tells the models apart: a length or an absolute value loses it.
// - Neither model has a highlight behind the surface, so there they are equal.
// - Light and camera may be opposite each other. What is h then? A NaN here is a black or white dot in the picture.
// - The report wants to know which model's highlight is the wider one, and why.
glm::vec3 computeLinearGradientModelComparison(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient)
{
    notWrittenYet("computeLinearGradientModelComparison"); // delete this line when the function is written
    return computeLambertianModel(state, cameraDirection, lightDirection, lightColor, hitInfo, hitInfo.material.kd);
}
