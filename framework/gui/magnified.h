#pragma once
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>
#include <imgui.h>

namespace gui {

// A part of a plane, shown magnified in a window: the plane's y points up, the window's down.
struct Magnified {
    glm::vec2 topLeft { 0.0f }; // in the window
    glm::vec2 first { 0.0f }, last { 1.0f }; // of the part
    float scale = 1.0f; // pixels of the window for 1

    [[nodiscard]] glm::vec2 toWindow(const glm::vec2& point) const
    {
        return topLeft + scale * glm::vec2(point.x - first.x, last.y - point.y);
    }

    // Its edges are shown.
    [[nodiscard]] bool shows(const glm::vec2& point) const
    {
        return glm::all(glm::lessThanEqual(first, point)) && glm::all(glm::lessThanEqual(point, last));
    }
};

// A point of the part in the window, for Dear ImGui.
[[nodiscard]] inline ImVec2 at(const Magnified& part, const glm::vec2& point)
{
    const glm::vec2 p = part.toWindow(point);
    return { p.x, p.y };
}

}
