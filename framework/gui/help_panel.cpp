#include "gui/panels.h"
#include <imgui.h>

namespace gui {

void helpPanel(bool& isOpen)
{
    if (!isOpen)
        return;
    if (ImGui::Begin("help", &isOpen, ImGuiWindowFlags_AlwaysAutoResize)) {
        constexpr const char* lines[][2] {
            { "left drag", "turn the camera" },
            { "right drag", "move what it looks at" },
            { "wheel", "closer, farther" },
            { "R", "follow the ray through the pixel under the mouse" },
            { "T", "traced, or rasterised" },
            { "F", "show the next quantity, in false colours" },
            { "Escape", "forget the ray" },
            { "Ctrl+Z, Ctrl+Y", "undo, redo" },
            { "?", "this page" },
        };
        for (const auto& [key, meaning] : lines) {
            ImGui::TextUnformatted(key);
            ImGui::SameLine(150.0f);
            ImGui::TextUnformatted(meaning);
        }
    }
    ImGui::End();
}

}
