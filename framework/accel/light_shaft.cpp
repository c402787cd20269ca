#include "accel/light_shaft.h"
#include "accel/wide/tree.h"
#include "bvh_interface.h"
#include "render.h"
#include "scene.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>

namespace accel {

// Samples on the light's rim are rounded; they shall be within.
static constexpr float widening = 0x1p-16f;

bool LightShaft::isClearWithin(const RenderState& state, const BVHInterface& bvh, const Ray& ray)
{
    if (m_stage == Stage::Unseen)
        look(state, bvh, ray);
    if (m_stage != Stage::Clear || m_bvh != &bvh || !contains(ray))
        return false;
    m_account.earn();
    return true;
}

void LightShaft::look(const RenderState& state, const BVHInterface& bvh, const Ray& first)
{
    m_stage = Stage::Unclear;
    if (!m_account.isWorthLooking() || !startAt(first.origin) || !contains(first))
        return;
    m_account.pay();
    m_bvh = &bvh;
    if (isClear(state, bvh))
        m_stage = Stage::Clear;
}

// The light is within them.
using Corners = std::array<glm::vec3, 4>;

static Corners cornersOf(const SegmentLight* light)
{
    return { light->endpoint0, light->endpoint0, light->endpoint1, light->endpoint1 };
}

static Corners cornersOf(const ParallelogramLight* light)
{
    const glm::vec3 v1 = light->v0 + light->edge01;
    return { light->v0, v1, light->v0 + light->edge02, v1 + light->edge02 };
}

static unsigned longestAxis(const glm::vec3& v)
{
    const glm::vec3 size = glm::max(v, -v);
    return size.z > size.x && size.z > size.y ? 2 : size.y > size.x ? 1 : 0;
}

// False if the light is beside the point, or around it.
bool LightShaft::startAt(const glm::vec3& point)
{
    const Corners corners = std::visit([](const auto* light) { return cornersOf(light); }, m_light);
    const glm::vec3 towards = corners[0] + corners[3] - 2.0f * point;
    const unsigned z = longestAxis(towards);
    m_forward = std::copysign(1.0f, towards[z]);
    m_shaft.axes[0] = (z + 1) % 3;
    m_shaft.axes[1] = (z + 2) % 3;
    m_shaft.axes[2] = z;
    glm::vec2 least(1.0f), largest(-1.0f);
    m_end = 0.0f;
    for (const glm::vec3& corner : corners) {
        const glm::vec3 way = turned(corner - point);
        if (!(way.z > 0.0f))
            return false;
        const glm::vec2 slopes = glm::vec2(way) / way.z;
        least = glm::min(least, slopes);
        largest = glm::max(largest, slopes);
        m_end = std::max(m_end, way.z);
    }
    constexpr float steepest = 1.0f - 0x1p-20f; // beyond, rays turn another axis into z
    for (int i = 0; i < 2; ++i) {
        m_shaft.least[i] = std::max(least[i] - widening, -steepest);
        m_shaft.largest[i] = std::min(largest[i] + widening, steepest);
    }
    for (int i = 0; i < 3; ++i)
        m_shaft.point[i] = point[i];
    m_end *= 1.0f + widening;
    m_shaft.end = m_forward * m_end;
    return true;
}

bool LightShaft::isClear(const RenderState& state, const BVHInterface& bvh) const
{
    if (state.needs.spheres)
        for (const Sphere& sphere : state.scene.spheres)
            if (!isClearOf(sphere))
                return false;
    if (!state.needs.triangles)
        return true;
    const WideTree* tree = bvh.wideTree();
    return tree && tree->isClear(m_shaft);
}

// A plane through the point has the sphere on one side and the shaft on the other: one of the shaft's sides, or that at
// a right angle to where the sphere is.
bool LightShaft::isClearOf(const Sphere& sphere) const
{
    const glm::vec3 way = turned(sphere.center - glm::make_vec3(m_shaft.point));
    const glm::vec3 size = glm::max(way, -way);
    const float radius
        = std::abs(sphere.radius) + 0x1p-18f * (size.x + size.y + size.z); // a ray's test has a dozen roundings
    if (glm::dot(way, way) <= radius * radius)
        return false;
    float towards = way.z; // of the segments' ends, at z = 1, the most
    for (int i = 0; i < 2; ++i) {
        const float least = m_shaft.least[i], largest = m_shaft.largest[i];
        if (way[i] - largest * way.z > radius * (1.0f + 0.5f * largest * largest)
            || least * way.z - way[i] > radius * (1.0f + 0.5f * least * least))
            return true;
        towards += std::max(least * way[i], largest * way[i]);
    }
    return towards <= 0.0f;
}

bool LightShaft::contains(const Ray& ray) const
{
    if (std::memcmp(m_shaft.point, &ray.origin, sizeof ray.origin) != 0)
        return false;
    const glm::vec3 way = turned(ray.direction);
    // Not so short or long that products of what the ray's own test multiplies have fewer digits, or are infinite.
    const bool hasDigits = way.z > 0x1p-40f && way.z < 0x1p40f;
    return hasDigits && way.z * ray.t <= m_end && m_shaft.least[0] * way.z <= way.x
        && way.x <= m_shaft.largest[0] * way.z && m_shaft.least[1] * way.z <= way.y
        && way.y <= m_shaft.largest[1] * way.z;
}

}
