#include "shapes/solid.h"
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtx/component_wise.hpp>

namespace shapes {
namespace {

    float distanceTo(const Limb& limb, const glm::vec3& center, const glm::vec3& point)
    {
        const glm::vec3 p = (point - center) / limb.stretch + center - limb.from;
        const glm::vec3 axis = limb.to - limb.from;
        const float length2 = glm::dot(axis, axis);
        const float along = length2 > 0.0f ? glm::clamp(glm::dot(p, axis) / length2, 0.0f, 1.0f) : 0.0f;
        const float radius = glm::mix(limb.fromRadius, limb.toRadius, along);
        return (glm::length(p - along * axis) - radius) * glm::compMin(limb.stretch);
    }

    // The smaller of two distances, rounded off where they differ by less than blend. Quilez 2013, "Smooth minimum".
    float smoothMin(float a, float b, float blend)
    {
        const float overlap = std::max(blend - std::abs(a - b), 0.0f);
        return std::min(a, b) - (overlap > 0.0f ? overlap * overlap / (4.0f * blend) : 0.0f);
    }

}

Solid::Piece Solid::makePiece(const Limb& limb, float blend, bool hollow)
{
    const float radius = std::max(limb.fromRadius, limb.toRadius);
    const float longest = glm::compMax(limb.stretch);
    const float reach = (0.5f * glm::distance(limb.from, limb.to) + radius) * longest;
    return { limb, blend, hollow, 0.5f * (limb.from + limb.to), reach, longest / glm::compMin(limb.stretch) };
}

float Solid::value(const glm::vec3& point) const
{
    float value = std::numeric_limits<float>::max();
    for (const Piece& piece : m_pieces) {
        // A limb this far away changes nothing: the ball around it is already farther than the blend reaches.
        const float far = piece.reach + piece.slack * (piece.blend + (piece.hollow ? -value : value));
        const glm::vec3 offset = point - piece.center;
        if (far <= 0.0f || glm::dot(offset, offset) >= far * far)
            continue;
        const float distance = distanceTo(piece.limb, piece.center, point);
        value = piece.hollow ? -smoothMin(-value, distance, piece.blend) : smoothMin(value, distance, piece.blend);
    }
    return value;
}

glm::vec3 Solid::gradient(const glm::vec3& point, float step) const
{
    // Four corners of a tetrahedron: with six central differences everything takes half as long again.
    glm::vec3 sum { 0.0f };
    for (const glm::vec3 corner :
        { glm::vec3(1, 1, 1), glm::vec3(1, -1, -1), glm::vec3(-1, 1, -1), glm::vec3(-1, -1, 1) })
        sum += corner * value(point + step * corner);
    return sum / (4.0f * step);
}

Solid Solid::near(const glm::vec3& center, float radius) const
{
    Solid part;
    for (const Piece& piece : m_pieces) {
        if (glm::distance(center, piece.center) < radius + piece.reach + piece.slack * piece.blend)
            part.m_pieces.push_back(piece);
    }
    return part;
}

}
