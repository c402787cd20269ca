#include "recursive.h"
#include "draw.h"

// How far a new ray starts from the surface: well above the error of the hit point, well below what can be seen. The
// error follows the numbers that the point is calculated from, whatever the scene's scale: pbrt, "Managing Rounding
// Error". A hit on a triangle no larger than these numbers has a dozen roundings of 2^-24; here are 512.
static float originOffset(const Ray& ray)
{
    const glm::vec3 way = ray.t * ray.direction;
    const glm::vec3 size = glm::max(ray.origin, -ray.origin) + glm::max(way, -way); // glm::abs would jump by signs
    return 0x1p-15f * std::max({ size.x, size.y, size.z });
}

Ray generateReflectionRay(Ray ray, HitInfo hitInfo)
{
    const glm::vec3 point = ray.origin + ray.t * ray.direction;
    const glm::vec3 mirrored = ray.direction - 2.0f * glm::dot(ray.direction, hitInfo.normal) * hitInfo.normal;
    // The normal faces the incoming ray: along it, even a grazing ray gets off the surface.
    return { .origin = point + originOffset(ray) * hitInfo.normal, .direction = glm::normalize(mirrored) };
}

Ray generatePassthroughRay(Ray ray, HitInfo hitInfo)
{
    const glm::vec3 point = ray.origin + ray.t * ray.direction;
    return { .origin = point - originOffset(ray) * hitInfo.normal, .direction = ray.direction };
}

void renderRaySpecularComponent(RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth)
{
    const Ray reflected = generateReflectionRay(ray, hitInfo);
    hitColor += hitInfo.material.ks * renderRay(state, reflected, rayDepth + 1);

    drawRay({ reflected.origin, hitInfo.normal, 0.2f }, glm::vec3(1.0f, 1.0f, 0.0f));
    drawRay(reflected, glm::vec3(0.0f, 1.0f, 0.0f));
}

void renderRayTransparentComponent(
    RenderState& state, Ray ray, const HitInfo& hitInfo, glm::vec3& hitColor, int rayDepth)
{
    const Ray passthrough = generatePassthroughRay(ray, hitInfo);
    const float alpha = hitInfo.material.transparency;
    hitColor = glm::mix(renderRay(state, passthrough, rayDepth + 1), hitColor, alpha);

    drawSphere(passthrough.origin, 0.01f, hitInfo.material.kd * alpha);
    drawRay(passthrough, hitColor);
}
