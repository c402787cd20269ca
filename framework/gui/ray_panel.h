#pragma once
#include "debug/strokes.h"
#include "worker/debug_ray.h"
#include <optional>
#include <set>

namespace gui {

// A ray that was followed: a list of what was drawn on its way, and the same over the picture.
class RayPanel {
public:
    void show(worker::DebugRay ray);
    void forget() { m_ray.reset(); }
    [[nodiscard]] bool isShowing() const { return m_ray.has_value(); }
    [[nodiscard]] const std::optional<worker::DebugRay>& followed() const { return m_ray; }

    void list(); // in the current ImGui window

    // Over the picture that a camera sees in this area of the window: a click on what is drawn there selects it.
    void control(const Trackball& camera, const glm::vec2& first, const glm::vec2& last);
    void drawOver(const Trackball& camera, const glm::vec2& first, const glm::vec2& last) const;

    // What is drawn over a picture of this size.
    [[nodiscard]] std::vector<debug::Stroke> strokes(const Trackball& camera, glm::ivec2 size) const;
    [[nodiscard]] std::size_t numShown() const;
    [[nodiscard]] std::optional<std::size_t> selected() const { return m_selected; }
    [[nodiscard]] bool isToBeSeen() const { return m_scrollsToSelected; } // what was selected, in the list

private:
    [[nodiscard]] bool isShown(std::size_t shape) const;

    std::optional<worker::DebugRay> m_ray;
    int m_numInOrder = 0; // of the boxes, those visited first
    bool m_showsBoxes = true, m_showsShadowRays = true;
    std::optional<std::size_t> m_selected;
    bool m_scrollsToSelected = false;
    std::set<std::size_t> m_boxes; // shapes that are boxes on the path
};

}
