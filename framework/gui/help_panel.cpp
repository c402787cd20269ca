#include "gui/panels.h"
#include "gui/scale.h"

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
            { "click on a stroke", "select it in the list of the ray" },
            { "Escape", "forget the ray" },
            { "drag a light's disc", "move it (lights, light handles)" },
            { "drop a file", "open a scene, a model or a camera" },
            { "Ctrl+Z, Ctrl+Y", "undo, redo" },
            { "?", "this page" },
        };
        for (const auto& [key, meaning] : lines) {
            ImGui::TextUnformatted(key);
            ImGui::SameLine(170.0f * scale());
            ImGui::TextUnformatted(meaning);
        }
    }
    ImGui::End();
}

}
