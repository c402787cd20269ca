#include "accel/wide/clip.h"

namespace accel::wide {
namespace {

    Float4 magnitude(Float4 a)
    {
        return a < 0.0f ? -a : a;
    }

    // A box around the point where the edge crosses the plane. Six roundings of at most the corners' size move the
    // point, each by 2^-24 of it at most: the margin is more.
    Box crossing(Float4 from, Float4 to, int axis, float position)
    {
        const float s = (position - from[axis]) / (to[axis] - from[axis]);
        const Float4 point = from + s * (to - from);
        const Float4 margin = (magnitude(from) + magnitude(to)) * 0x1p-21f;
        Box box { point - margin, point + margin };
        box.lower[axis] = box.upper[axis] = position;
        return box;
    }

}

Halves clip(const Box& box, const Triangle& triangle, int axis, float position)
{
    Halves halves { Box::empty(), Box::empty() };
    Float4 from = toFloat4(triangle[2]);
    for (const glm::vec3& corner : triangle) {
        const Float4 to = toFloat4(corner);
        if (to[axis] <= position)
            halves.lower.add(to);
        if (to[axis] >= position)
            halves.upper.add(to);
        if ((from[axis] < position && position < to[axis]) || (to[axis] < position && position < from[axis])) {
            const Box both = crossing(from, to, axis, position);
            halves.lower.add(both);
            halves.upper.add(both);
        }
        from = to;
    }
    return { intersect(halves.lower, box), intersect(halves.upper, box) };
}

}
