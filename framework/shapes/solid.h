#pragma once
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

namespace shapes {

// A ball that moves from one centre to another while its radius changes: a sphere, a limb, a horn.
struct Limb {
    glm::vec3 from, to;
    float fromRadius, toRadius;
    glm::vec3 stretch { 1.0f }; // of the limb about the middle of from and to, along the axes: makes ellipsoids
};

// An organic body: limbs that melt into each other, and hollows.
class Solid {
public:
    // Unites with the limb, or hollows it out of what is there so far. Within a distance of blend the two surfaces
    // melt together.
    void add(const Limb& limb, float blend) { m_pieces.push_back(makePiece(limb, blend, false)); }
    void carve(const Limb& limb, float blend) { m_pieces.push_back(makePiece(limb, blend, true)); }

    // Negative inside, 0 on the surface, positive outside; near the surface about the distance to it.
    [[nodiscard]] float value(const glm::vec3& point) const;

    // The direction in which value() grows, by differences over this step: its length is about 1.
    [[nodiscard]] glm::vec3 gradient(const glm::vec3& point, float step) const;

    // The pieces that shape the surface within a ball.
    [[nodiscard]] Solid near(const glm::vec3& center, float radius) const;

private:
    struct Piece {
        Limb limb;
        float blend;
        bool hollow;
        glm::vec3 center; // of a ball that holds the limb
        float reach; // that ball's radius
        float slack; // how many times longer the way to the limb may be than its distance says, if it is stretched
    };

    static Piece makePiece(const Limb& limb, float blend, bool hollow);

    std::vector<Piece> m_pieces;
};

}
