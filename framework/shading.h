#pragma once
#include "common.h"
#include "fwd.h"
#include "render.h"
#include <vector>

// Colours along a line, linear between the components.
struct LinearGradient {
    struct Component {
        float t; // in [-1, 1]
        glm::vec3 color;
    };

    std::vector<Component> components; // in any order

    // To implement: the colour at ti in [-1, 1]: linear between the neighbouring components; below the first or above
    // the last, that one's colour; of equal positions either; without components black.
    [[nodiscard]] glm::vec3 sample(float ti) const;
};

// In all models cameraDirection and lightDirection are unit and point away from the surface; lightColor is what
// arrives along lightDirection; the result is what leaves along cameraDirection.

// Provided: the model that the features select; lightColor * kd with shading off.
[[nodiscard]] glm::vec3 computeShading(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo);

// Provided: the material's kd, or its texture at the hit when texture mapping is on.
[[nodiscard]] glm::vec3 sampleMaterialKd(RenderState& state, const HitInfo& hitInfo);

// Provided: lightColor * kd * max(n.l, 0).
[[nodiscard]] glm::vec3 computeLambertianModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo, const glm::vec3& kd);

// Provided: Lambert + lightColor * ks * max(r.v, 0)^shininess, r = l mirrored about n; no light behind the surface.
// Phong 1975, "Illumination for Computer Generated Pictures".
[[nodiscard]] glm::vec3 computePhongModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo, const glm::vec3& kd);

// Provided: Lambert + lightColor * ks * max(n.h, 0)^shininess, h halfway between l and v; no light behind the surface.
// Blinn 1977, "Models of Light Reflection for Computer Synthesized Pictures".
[[nodiscard]] glm::vec3 computeBlinnPhongModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo, const glm::vec3& kd);

// To implement: lightColor * gradient.sample(cosine of the angle between light and normal, clamped to [-1, 1]).
[[nodiscard]] glm::vec3 computeLinearGradientModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient);

// To implement: a colour of the gradient for the difference of the specular terms of Phong and Blinn-Phong: one half
// of [-1, 1] where Phong is brighter, the other where Blinn-Phong is, 0 where they are equal.
[[nodiscard]] glm::vec3 computeLinearGradientModelComparison(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo,
    const LinearGradient& gradient);

// The models of the 2023-24 edition, which look up kd themselves.
[[nodiscard]] glm::vec3 computeLambertianModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo);
[[nodiscard]] glm::vec3 computePhongModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo);
[[nodiscard]] glm::vec3 computeBlinnPhongModel(RenderState& state, const glm::vec3& cameraDirection,
    const glm::vec3& lightDirection, const glm::vec3& lightColor, const HitInfo& hitInfo);
