#include "gui/output_panel.h"
#include "gui/scale.h"
#include <utility>

namespace gui {

void OutputPanel::add(std::string_view printed)
{
    m_isFirst = m_isFirst || (m_printed.lines().empty() && !printed.empty());
    m_printed.append(printed);
}

void OutputPanel::show()
{
    if (std::exchange(m_isFirst, false))
        ImGui::SetNextItemOpen(true);
    if (!ImGui::CollapsingHeader("output"))
        return;
    if (ImGui::Button("clear"))
        m_printed.clear();
    ImGui::SameLine();
    ImGui::Text("%zu lines", m_printed.lines().size());
    ImGui::BeginChild("printed", { 0.0f, 130.0f * scale() }, true, ImGuiWindowFlags_HorizontalScrollbar);
    list();
    ImGui::EndChild();
}

void OutputPanel::list()
{
    const auto& lines = m_printed.lines();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lines.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const std::string& line = lines[static_cast<std::size_t>(i)];
            ImGui::TextUnformatted(line.data(), line.data() + line.size());
        }
    // Whoever scrolls back reads on in peace.
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY())
        ImGui::SetScrollHereY(1.0f);
}

}
