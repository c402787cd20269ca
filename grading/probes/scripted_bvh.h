#pragma once
#include "bvh_interface.h"
#include "grading/probes/recursion.h"

namespace grading {

// Answers each new ray with the next hit of a script, and remembers the rays. A ray that is sent again, to be drawn up
// to its hit for instance, meets the same again, whatever was sent between.
class ScriptedBVH : public BVHInterface {
public:
    explicit ScriptedBVH(std::vector<ScriptedHit> hits)
        : m_hits(std::move(hits))
    {
    }

    bool intersect(RenderState&, Ray& ray, HitInfo& hitInfo) const override
    {
        if (++m_numAsked > enough)
            return false;
        const std::size_t index = indexOf(ray);
        if (index >= m_hits.size())
            return false;
        const ScriptedHit& hit = m_hits[index];
        ray.t = hit.t;
        hitInfo = {};
        hitInfo.normal = glm::dot(hit.normal, ray.direction) > 0.0f ? -hit.normal : hit.normal;
        hitInfo.material = hit.material;
        return true;
    }

    [[nodiscard]] const std::vector<Ray>& rays() const { return m_rays; }

    [[nodiscard]] std::span<const Node> nodes() const override { return {}; }
    [[nodiscard]] std::span<Node> nodes() override { return {}; }
    [[nodiscard]] std::span<const Primitive> primitives() const override { return {}; }
    [[nodiscard]] std::span<Primitive> primitives() override { return {}; }
    [[nodiscard]] uint32_t numLevels() const override { return 0; }
    [[nodiscard]] uint32_t numLeaves() const override { return 0; }

private:
    static constexpr int enough = 1000; // a recursion that repeats one ray at one depth ends here

    // Of the rays that differ, in the order sent.
    std::size_t indexOf(const Ray& ray) const
    {
        const auto isSame = [&](const Ray& r) { return r.origin == ray.origin && r.direction == ray.direction; };
        const auto known = std::find_if(m_rays.begin(), m_rays.end(), isSame);
        const auto index = static_cast<std::size_t>(known - m_rays.begin());
        if (known == m_rays.end())
            m_rays.push_back(ray);
        return index;
    }

    std::vector<ScriptedHit> m_hits;
    mutable std::vector<Ray> m_rays;
    mutable int m_numAsked = 0;
};

}
