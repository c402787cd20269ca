#include "gui/tree_panel.h"
#include "gui/stroke_drawing.h"
#include <imgui.h>

namespace gui {
namespace {

    // A submission may count as it likes; ImGui takes half of all integers.
    int toInt(uint32_t count)
    {
        return static_cast<int>(std::min(count, 1'000'000'000u));
    }

    void choose(const char* what, const char* which, bool& isShown, int& index, int first, int last)
    {
        ImGui::Checkbox(what, &isShown);
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1.0f);
        ImGui::SliderInt(which, &index, first, std::max(first, last), "%d", ImGuiSliderFlags_AlwaysClamp);
    }

}

void TreePanel::controls()
{
    const int numLevels = toInt(m_drawing.numLevels), numLeaves = toInt(m_drawing.numLeaves);
    ImGui::Text("%d levels, %d leaves", numLevels, numLeaves);
    choose("level", "##which level", m_showsLevel, m_level, 0, numLevels - 1);
    choose("leaf", "##which leaf", m_showsLeaf, m_leaf, 1, numLeaves);
    if (m_drawing.numDropped > 0)
        ImGui::Text("%zu shapes are drawn, %zu more are not", m_drawing.shapes.size(), m_drawing.numDropped);
}

worker::TreeRequest TreePanel::wanted() const
{
    worker::TreeRequest request;
    if (m_showsLevel)
        request.level = m_level;
    if (m_showsLeaf)
        request.leaf = m_leaf;
    return request;
}

// Another tree may have fewer.
void TreePanel::show(worker::TreeDrawing drawing)
{
    m_drawing = std::move(drawing);
    m_level = std::clamp(m_level, 0, std::max(toInt(m_drawing.numLevels) - 1, 0));
    m_leaf = std::clamp(m_leaf, 1, std::max(toInt(m_drawing.numLeaves), 1));
}

void TreePanel::drawOver(const Trackball& camera, const glm::vec2& first, const glm::vec2& last) const
{
    const debug::Projection projection { camera, glm::ivec2(last - first) };
    drawStrokes(strokesOf(m_drawing.shapes, projection), {}, first, last);
}

}
