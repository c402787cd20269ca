#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <limits>

namespace accel::wide {

// Three coordinates and a fourth that nobody looks at, so that the compiler takes one instruction for all.
using Float4 = float __attribute__((vector_size(16)));

inline Float4 toFloat4(const glm::vec3& v)
{
    return Float4 { v.x, v.y, v.z, 0.0f };
}
inline Float4 min(Float4 a, Float4 b)
{
    return a < b ? a : b;
}
inline Float4 max(Float4 a, Float4 b)
{
    return a > b ? a : b;
}

struct Box {
    Float4 lower, upper;

    static Box empty()
    {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        return { Float4 {} + infinity, Float4 {} - infinity };
    }

    void add(Float4 point)
    {
        lower = min(lower, point);
        upper = max(upper, point);
    }

    void add(const Box& box)
    {
        lower = min(lower, box.lower);
        upper = max(upper, box.upper);
    }

    // Of nothing: not a number.
    [[nodiscard]] float halfArea() const
    {
        const Float4 size = upper - lower;
        return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }

    [[nodiscard]] bool isFinite() const
    {
        const Float4 size = (lower - lower) + (upper - upper); // not zero, but not a number, for infinity
        return size[0] == 0.0f && size[1] == 0.0f && size[2] == 0.0f;
    }

    [[nodiscard]] bool isEmpty() const
    {
        return !(lower[0] <= upper[0] && lower[1] <= upper[1] && lower[2] <= upper[2]);
    }
};

inline Box unite(Box a, const Box& b)
{
    a.add(b);
    return a;
}

inline Box intersect(const Box& a, const Box& b)
{
    return { max(a.lower, b.lower), min(a.upper, b.upper) };
}

using Triangle = std::array<glm::vec3, 3>;

// A triangle, or the part of it that lies in a box.
struct Reference {
    Box box;

    // The box has room for it where nobody looks.
    [[nodiscard]] uint32_t primitive() const
    {
        uint32_t index;
        const float bits = box.lower[3];
        std::memcpy(&index, &bits, sizeof index);
        return index;
    }

    void setPrimitive(uint32_t index)
    {
        float bits;
        std::memcpy(&bits, &index, sizeof bits);
        box.lower[3] = bits;
    }

    [[nodiscard]] Float4 doubledCentroid() const { return box.lower + box.upper; }
};

}
