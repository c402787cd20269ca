#pragma once
#include "accel/wide/node.h"
#include "bench/model.h"
#include <framework/ray.h>
#include <limits>
#include <optional>
#include <span>

namespace bench {

// What single precision found, by a search of all triangles in double precision.
enum class Verdict {
    Exact, // the same triangle, or none
    Tie, // another, or none where there is one: roundings decide, at an edge, or between two at the same distance
    Wrong,
};

// What a ray meets: the oracle for a traversal. It shares no code with what it judges: sides of edges and distances are
// volumes of the corners as seen from the ray's origin, in double precision.
class ExactHits {
public:
    ExactHits(std::span<const Triangle> triangles, const Ray& ray);

    // The closest hit, with its distance and weights.
    [[nodiscard]] Verdict judge(const std::optional<accel::wide::Hit>& found) const;
    // Whether there is any.
    [[nodiscard]] Verdict judge(bool found) const;

private:
    void add(const Triangle& triangle);
    [[nodiscard]] bool isAt(const accel::wide::Hit& hit) const;

    static constexpr double infinity = std::numeric_limits<double>::infinity();

    std::span<const Triangle> m_triangles;
    Ray m_ray;
    double m_tolerance; // what roundings may move, in units of space
    double m_closest = infinity, m_closestSure = infinity; // distances; sure: beyond all rounding
    const Triangle* m_triangle = nullptr; // the closest
    bool m_mayHit = false; // with rounding
};

}
