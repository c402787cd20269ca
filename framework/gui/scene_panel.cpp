#include "gui/scene_panel.h"
#include "submission/paths.h"
#include <imgui.h>

namespace gui {

namespace fs = std::filesystem;

std::optional<fs::path> ScenePanel::pick(const fs::path& open)
{
    std::optional<fs::path> picked;
    if (ImGui::BeginCombo("file", open.stem().c_str())) {
        for (const auto& entry : fs::directory_iterator(fs::path(submission::sourceDirectory) / "scenes"))
            if (entry.path().extension() == ".toml" && ImGui::Selectable(entry.path().stem().c_str()))
                picked = entry.path();
        ImGui::EndCombo();
    }
    if (ImGui::InputTextWithHint(
            "open", "path, then Enter", m_typed.data(), m_typed.size(), ImGuiInputTextFlags_EnterReturnsTrue)
        && m_typed[0] != '\0')
        picked = m_typed.data();
    return picked;
}

}
