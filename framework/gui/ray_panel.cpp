#include "gui/ray_panel.h"
#include "gui/scale.h"
#include "gui/stroke_at.h"
#include "gui/stroke_drawing.h"
#include <fmt/format.h>
#include <framework/variant_helper.h>
#include <imgui.h>

namespace gui {
namespace {

    using namespace debug;

    std::string toText(const glm::vec3& v)
    {
        return fmt::format("({:.3g}, {:.3g}, {:.3g})", v.x, v.y, v.z);
    }

    std::string describe(const Drawn& drawn)
    {
        return std::visit(
            make_visitor(
                [](const DrawnRay& r) {
                    return r.ray.t == FLT_MAX ? "ray along " + toText(r.ray.direction)
                                              : "ray to " + toText(r.ray.origin + r.ray.t * r.ray.direction);
                },
                [](const DrawnBox& b) { return "box " + toText(b.box.lower) + " to " + toText(b.box.upper); },
                [](const DrawnTriangle& t) { return "triangle at " + toText(t.v0.position); },
                [](const DrawnSphere& s) { return "sphere at " + toText(s.center); }),
            drawn);
    }

    glm::vec3 colorOf(const Drawn& drawn)
    {
        return std::visit(make_visitor([](const DrawnTriangle&) { return glm::vec3(1.0f); },
                              [](const auto& shape) { return shape.color; }),
            drawn);
    }

    bool isBox(const Shape& shape)
    {
        return std::holds_alternative<DrawnBox>(shape.drawn);
    }

}

void RayPanel::show(worker::DebugRay ray)
{
    m_ray = std::move(ray);
    m_selected.reset();
    m_boxes.clear();
    for (std::size_t i = 0; i < m_ray->shapes.size(); ++i)
        if (isBox(m_ray->shapes[i]))
            m_boxes.insert(i);
    m_numInOrder = static_cast<int>(m_boxes.size());
}

bool RayPanel::isShown(std::size_t shape) const
{
    const Shape& s = m_ray->shapes[shape];
    if (s.cause.way == Way::Shadow && !m_showsShadowRays)
        return false;
    if (!isBox(s))
        return true;
    return m_showsBoxes && std::distance(m_boxes.begin(), m_boxes.find(shape)) < m_numInOrder;
}

std::size_t RayPanel::numShown() const
{
    std::size_t count = 0;
    for (std::size_t i = 0; m_ray && i < m_ray->shapes.size(); ++i)
        count += isShown(i);
    return count;
}

void RayPanel::list()
{
    if (!m_ray) {
        ImGui::TextUnformatted("R follows the ray under the mouse");
        return;
    }
    ImGui::Text("pixel %d, %d: %s", m_ray->pixel.x, m_ray->pixel.y, toText(m_ray->color).c_str());
    ImGui::Checkbox("boxes", &m_showsBoxes);
    ImGui::SameLine();
    ImGui::Checkbox("shadow rays", &m_showsShadowRays);
    ImGui::SliderInt("visited", &m_numInOrder, 0, static_cast<int>(m_boxes.size()));
    for (std::size_t i = 0; i < m_ray->shapes.size(); ++i) {
        if (!isShown(i))
            continue;
        const auto& [drawn, cause] = m_ray->shapes[i];
        const glm::vec3 color = colorOf(drawn);
        const std::string line = fmt::format(
            "{} {}{}##{}", cause.bounce, cause.way == Way::Shadow ? "to a light: " : "", describe(drawn), i);
        ImGui::PushStyleColor(ImGuiCol_Text, { color.x, color.y, color.z, 1.0f });
        if (ImGui::Selectable(line.c_str(), m_selected == i))
            m_selected = m_selected == i ? std::nullopt : std::optional(i);
        ImGui::PopStyleColor();
        if (m_scrollsToSelected && m_selected == i)
            ImGui::SetScrollHereY();
    }
    m_scrollsToSelected = false;
}

std::vector<Stroke> RayPanel::strokes(const Trackball& camera, glm::ivec2 size) const
{
    if (!m_ray)
        return {};
    std::vector<Stroke> strokes = strokesOf(m_ray->shapes, Projection(camera, size));
    std::erase_if(strokes, [&](const Stroke& stroke) { return !isShown(stroke.shape); });
    return strokes;
}

// A button that is released where it was pressed; the camera turns while it is dragged.
static bool isClicked(const ImGuiIO& io)
{
    return ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !io.WantCaptureMouse
        && !io.MouseDownOwned[ImGuiMouseButton_Left]
        && io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < io.MouseDragThreshold * io.MouseDragThreshold;
}

void RayPanel::control(const Trackball& camera, const glm::vec2& first, const glm::vec2& last)
{
    constexpr float radius = 6.0f; // pixels of an ordinary screen
    const ImGuiIO& io = ImGui::GetIO();
    if (!m_ray || !isClicked(io))
        return;
    const glm::vec2 place { io.MousePos.x - first.x, last.y - io.MousePos.y };
    m_selected = shapeAt(strokes(camera, glm::ivec2(last - first)), place, radius * scale());
    m_scrollsToSelected = m_selected.has_value();
}

void RayPanel::drawOver(const Trackball& camera, const glm::vec2& first, const glm::vec2& last) const
{
    const bool isSelectedShown = m_ray && m_selected && isShown(*m_selected);
    drawStrokes(strokes(camera, glm::ivec2(last - first)), isSelectedShown ? m_selected : std::nullopt, first, last);
}

}
