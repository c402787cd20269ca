#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace shapes {

// A point of a cubic lattice; also the cell between it and point + (1, 1, 1).
using Lattice = glm::ivec3;

inline constexpr std::array<std::size_t, 3> axes { 0, 1, 2 };

[[nodiscard]] inline Lattice unit(std::size_t axis)
{
    Lattice step { 0 };
    step[static_cast<int>(axis)] = 1;
    return step;
}

// The corners of a cell have numbers of three bits: its x, y and z from the cell's point.
[[nodiscard]] inline Lattice cornerOffset(std::size_t corner)
{
    return { corner & 1, corner >> 1 & 1, corner >> 2 & 1 };
}

// A number for use in hash tables, of 21 bits a coordinate.
[[nodiscard]] inline uint64_t keyOf(const Lattice& p)
{
    const auto bits = [](int coordinate) { return static_cast<uint64_t>(coordinate + (1 << 20)); };
    return bits(p.x) << 42 | bits(p.y) << 21 | bits(p.z);
}

// Some of the eight corners of a cell.
class Corners {
public:
    constexpr Corners() = default;

    constexpr void add(std::size_t corner) { m_bits |= 1u << corner; }
    [[nodiscard]] constexpr bool contains(std::size_t corner) const { return (m_bits >> corner & 1) != 0; }
    [[nodiscard]] constexpr bool some() const { return m_bits != 0; }
    [[nodiscard]] constexpr Corners others() const { return Corners(m_bits ^ 0xff); }
    [[nodiscard]] constexpr bool cutFace(std::size_t axis, int side) const
    {
        const unsigned face = side == 0 ? lowSide[axis] : lowSide[axis] ^ 0xff;
        return (m_bits & face) != 0 && (m_bits & face) != face;
    }

    // Whether the edges of the cell lead from each of the corners to each other one, over these corners alone.
    [[nodiscard]] constexpr bool areConnected() const
    {
        unsigned reached = m_bits & (0u - m_bits); // the first
        for (unsigned before = 0; before != reached;) {
            before = reached;
            for (const std::size_t axis : axes) {
                const unsigned step = 1u << axis;
                reached |= ((reached & lowSide[axis]) << step | (reached >> step & lowSide[axis])) & m_bits;
            }
        }
        return reached == m_bits;
    }

private:
    static constexpr std::array<unsigned, 3> lowSide { 0x55, 0x33, 0x0f }; // corners with a 0 in the axis' bit

    constexpr explicit Corners(unsigned bits)
        : m_bits(bits)
    {
    }

    unsigned m_bits = 0;
};

}
