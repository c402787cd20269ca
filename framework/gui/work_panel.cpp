#include "gui/work_panel.h"
#include "gui/scale.h"

namespace gui {
namespace {

    void list(const std::vector<worker::ExplainedLine>& lines, const char* table, float width)
    {
        if (!ImGui::BeginTable(table, 2, ImGuiTableFlags_SizingFixedFit))
            return;
        for (const auto& [what, value] : lines) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(what.c_str());
            ImGui::TableNextColumn();
            const float indent = width - ImGui::CalcTextSize(value.c_str()).x; // numbers stand below each other
            if (indent > 0.0f)
                ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
            ImGui::TextUnformatted(value.c_str());
        }
        ImGui::EndTable();
    }

    void explain(const Picture& picture, bool skips)
    {
        if (picture.quantity != debug::Quantity::Color)
            return ImGui::TextUnformatted("is counted while colours are traced");
        ImGui::TextUnformatted(worker::titleOfNeeds(skips).c_str());
        list(worker::linesOf(picture.needs), "needed", 0.0f);
        ImGui::Separator();
        ImGui::TextUnformatted(picture.isDone ? "done" : "done so far");
        list(worker::linesOf(picture.work), "done", 90.0f * scale());
    }

}

void workPanel(const Picture& picture, bool skips, bool& isOpen, glm::vec2 corner)
{
    if (!isOpen || picture.needs.empty())
        return;
    ImGui::SetNextWindowPos({ corner.x + 10.0f, corner.y - 10.0f }, ImGuiCond_FirstUseEver, { 0.0f, 1.0f });
    if (ImGui::Begin("work", &isOpen, ImGuiWindowFlags_AlwaysAutoResize))
        explain(picture, skips);
    ImGui::End();
}

}
