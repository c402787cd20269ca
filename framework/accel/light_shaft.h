#pragma once
#include "accel/wide/shaft.h"
#include "common.h"
#include "fwd.h"
#include <framework/ray.h>
#include <variant>

namespace accel {

// Tells whether anything lies between the shaded point and a light to which several rays are about to be sent: if
// nothing does, none of them needs to be traced by the library's tree. That is found out once for all, when the first
// ray comes, and seldom while it does not pay.
class LightShaft {
public:
    // Next, so many rays will lead to this light, which must stay where it is.
    template <typename AreaLight> void aimAt(const AreaLight& light, uint32_t numRays)
    {
        m_light = &light;
        m_stage = static_cast<float>(numRays) >= costOfLooking ? Stage::Unseen : Stage::Unclear;
    }

    // That the ray meets nothing, as isOccludedByBVH would find. If false, it has to be traced.
    [[nodiscard]] bool isClearFor(const RenderState& state, const BVHInterface& bvh, const Ray& ray)
    {
        return m_stage != Stage::Unclear && isClearWithin(state, bvh, ray);
    }

private:
    enum class Stage { Unseen, Clear, Unclear };

    static constexpr float costOfLooking = 4.0f; // in rays; fewer are traced as soon

    // Whether looking pays, by how it went so far: in rays that were saved, less what looking cost.
    class Account {
    public:
        [[nodiscard]] bool isWorthLooking()
        {
            if (m_balance >= 0.0f)
                return true;
            m_balance += hope;
            return false;
        }

        void pay() { m_balance -= costOfLooking; }
        void earn() { m_balance = std::min(m_balance + 1.0f, most); }

    private:
        static constexpr float hope = 0.25f; // for each time that nobody looks: sooner or later somebody does
        static constexpr float most = 8.0f; // so that a few failures are enough

        float m_balance = 0.0f;
    };

    [[nodiscard]] bool isClearWithin(const RenderState& state, const BVHInterface& bvh, const Ray& ray);
    void look(const RenderState& state, const BVHInterface& bvh, const Ray& first);
    [[nodiscard]] bool startAt(const glm::vec3& point);
    [[nodiscard]] bool isClear(const RenderState& state, const BVHInterface& bvh) const;
    [[nodiscard]] bool isClearOf(const Sphere& sphere) const;
    [[nodiscard]] bool contains(const Ray& ray) const;

    // In the shaft's axes, forward along z.
    [[nodiscard]] glm::vec3 turned(const glm::vec3& v) const
    {
        const unsigned* const axes = m_shaft.axes;
        return m_forward * glm::vec3(v[axes[0]], v[axes[1]], v[axes[2]]);
    }

    std::variant<const SegmentLight*, const ParallelogramLight*> m_light;
    Account m_account;
    Stage m_stage = Stage::Unclear;
    const BVHInterface* m_bvh; // where it is clear
    wide::Shaft m_shaft;
    float m_forward, m_end; // the sign of z in it, and how far it goes forward
};

}
