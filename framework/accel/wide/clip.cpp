#include "accel/wide/clip.h"

namespace accel::wide {
namespace {

    // A box around the point where the edge crosses the plane. In double precision the point is all but exact; what a
    // float cannot hold of it is less than the margin.
    Box crossing(const glm::vec3& from, const glm::vec3& to, int axis, float position)
    {
        const double start = static_cast<double>(from[axis]);
        const double s = (static_cast<double>(position) - start) / (static_cast<double>(to[axis]) - start);
        Box box;
        for (int i = 0; i < 3; ++i) {
            const double a = static_cast<double>(from[i]), b = static_cast<double>(to[i]);
            const double x = a + s * (b - a);
            const double margin = std::numeric_limits<float>::epsilon() * (x < 0.0 ? -x : x);
            box.lower[i] = static_cast<float>(x - margin);
            box.upper[i] = static_cast<float>(x + margin);
        }
        box.lower[axis] = box.upper[axis] = position;
        return box;
    }

}

Halves clip(const Box& box, const Triangle& triangle, int axis, float position)
{
    Halves halves { Box::empty(), Box::empty() };
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 &from = triangle[i], &to = triangle[(i + 1) % 3];
        if (from[axis] <= position)
            halves.lower.add(toFloat4(from));
        if (from[axis] >= position)
            halves.upper.add(toFloat4(from));
        if ((from[axis] < position && position < to[axis]) || (to[axis] < position && position < from[axis])) {
            const Box both = crossing(from, to, axis, position);
            halves.lower.add(both);
            halves.upper.add(both);
        }
    }
    return { intersect(halves.lower, box), intersect(halves.upper, box) };
}

}
