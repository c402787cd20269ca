#include "gui/light_handles.h"
#include "gui/scale.h"

namespace gui {
namespace {

    constexpr float discRadius = 7.0f, rimWidth = 1.5f, lineWidth = 2.0f; // pixels of an ordinary screen

    bool isAmong(const std::vector<Scene::SceneLight>& lights, const LightPoint& p)
    {
        return p.light < lights.size() && p.point < pointsOf(lights[p.light]).size();
    }

}

void LightHandles::showSwitch()
{
    ImGui::Checkbox("light handles", &m_isShown);
}

void LightHandles::control(
    std::vector<Scene::SceneLight>& lights, const Trackball& camera, const glm::vec2& first, const glm::vec2& last)
{
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::ivec2 size { last - first };
    m_mouse = { mouse.x - first.x, last.y - mouse.y };
    // What is undone while it is dragged may be gone.
    if (!m_isShown || !ImGui::IsMouseDown(ImGuiMouseButton_Left) || (m_dragged && !isAmong(lights, *m_dragged)))
        m_dragged.reset();
    if (!m_dragged)
        hover(lights, debug::Projection(camera, size));
    else if (const ImVec2 moved = ImGui::GetIO().MouseDelta; moved.x != 0.0f || moved.y != 0.0f)
        drag(lights, camera, size);
}

// A mouse that came with a button held down is turning the camera, and is not to be stopped.
void LightHandles::hover(const std::vector<Scene::SceneLight>& lights, const debug::Projection& projection)
{
    const bool isClicked = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    const bool isFree = !ImGui::GetIO().WantCaptureMouse && (isClicked || !ImGui::IsAnyMouseDown());
    m_hovered = m_isShown && isFree ? pointAt(lights, projection, m_mouse, discRadius * scale()) : std::nullopt;
    if (!m_hovered || !isClicked)
        return;
    m_dragged = m_hovered;
    m_grip = projection.point(pointsOf(lights[m_dragged->light])[m_dragged->point]).value_or(m_mouse) - m_mouse;
}

void LightHandles::drag(std::vector<Scene::SceneLight>& lights, const Trackball& camera, glm::ivec2 size) const
{
    Scene::SceneLight& light = lights[m_dragged->light];
    const glm::vec3 before = pointsOf(light)[m_dragged->point];
    // The mouse may be nowhere, and the wheel may have taken the camera past the light.
    if (ImGui::IsMousePosValid() && debug::Projection(camera, size).point(before))
        movePoint(light, m_dragged->point, positionAt(m_mouse + m_grip, camera, size, before));
}

void LightHandles::drawOver(const std::vector<Scene::SceneLight>& lights, const Trackball& camera,
    const glm::vec2& first, const glm::vec2& last) const
{
    if (!m_isShown)
        return;
    const debug::Projection projection { camera, glm::ivec2(last - first) };
    const auto toWindow = [&](const glm::vec2& shown) { return ImVec2(first.x + shown.x, last.y - shown.y); };
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({ first.x, first.y }, { last.x, last.y });
    const float radius = discRadius * scale();
    constexpr ImU32 rim = IM_COL32(0, 0, 0, 255), plain = IM_COL32(255, 240, 160, 255);
    constexpr ImU32 held = IM_COL32(255, 150, 40, 255);
    for (std::size_t light = 0; light < lights.size(); ++light) {
        for (const auto& [from, to] : linesOf(lights[light]))
            if (const auto shown = projection.line(from, to))
                list.AddLine(toWindow(shown->first), toWindow(shown->second), plain, lineWidth * scale());
        const auto points = pointsOf(lights[light]);
        for (std::size_t point = 0; point < points.size(); ++point)
            if (const auto shown = projection.point(points[point])) {
                list.AddCircleFilled(toWindow(*shown), radius, rim);
                list.AddCircleFilled(toWindow(*shown), radius - rimWidth * scale(),
                    m_hovered == LightPoint { light, point } ? held : plain);
            }
    }
    list.PopClipRect();
}

}
