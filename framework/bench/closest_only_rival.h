#pragma once
#include "bench/clock.h"
#include "bench/rival.h"
#include <cmath>
#include <limits>

namespace bench {

// One that knows the closest hit alone: it finds that too where any would do.
class ClosestOnlyRival : public Rival {
public:
    void load(std::span<const Ray> rays) override { m_rays.assign(rays.begin(), rays.end()); }

    double traceClosest() override
    {
        m_distances.clear();
        return secondsOf([&] {
            for (Ray ray : m_rays)
                m_distances.push_back(intersect(ray) ? ray.t : std::numeric_limits<float>::infinity());
        });
    }

    double traceOccluded() override { return traceClosest(); }

    [[nodiscard]] float distance(std::size_t ray) const override { return m_distances[ray]; }
    [[nodiscard]] bool isOccluded(std::size_t ray) const override { return std::isfinite(m_distances[ray]); }

private:
    [[nodiscard]] virtual bool intersect(Ray& ray) const = 0; // shortens the ray to what it meets

    std::vector<Ray> m_rays;
    std::vector<float> m_distances;
};

}
