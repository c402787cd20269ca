#pragma once
#include "gui/light_points.h"

namespace gui {

// Discs over the picture at the points of lights, to be dragged by the left mouse button. A point that is dragged
// stays as far ahead of the camera as it was.
class LightHandles {
public:
    void showSwitch(); // in the current ImGui window

    // What the mouse does to lights that a camera sees in this area of the window.
    void control(
        std::vector<Scene::SceneLight>& lights, const Trackball& camera, const glm::vec2& first, const glm::vec2& last);
    [[nodiscard]] bool isDragging() const { return m_dragged.has_value(); }
    [[nodiscard]] bool isUnderMouse() const { return m_hovered.has_value(); }

    // Over the picture in the same area.
    void drawOver(const std::vector<Scene::SceneLight>& lights, const Trackball& camera, const glm::vec2& first,
        const glm::vec2& last) const;

private:
    void hover(const std::vector<Scene::SceneLight>& lights, const debug::Projection& projection);
    void drag(std::vector<Scene::SceneLight>& lights, const Trackball& camera, glm::ivec2 size) const;

    bool m_isShown = false;
    glm::vec2 m_mouse { 0.0f }; // in pixels of the picture, from its bottom left
    std::optional<LightPoint> m_hovered, m_dragged;
    glm::vec2 m_grip { 0.0f }; // from the mouse to the point that is dragged
};

}
