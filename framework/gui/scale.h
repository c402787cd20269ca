#pragma once
#include <imgui.h>

namespace gui {

inline constexpr float plainFontSize = 13.0f; // pixels, of ImGui's own font

// Pixels of this screen for one of an ordinary screen: the size of everything that is drawn follows that of the text.
[[nodiscard]] inline float scale()
{
    return ImGui::GetFont()->FontSize / plainFontSize;
}

}
