#pragma once
#include <imgui.h>
#include <string>
#include <variant>
#include <vector>

struct ImGuiWindow;

namespace tests {

// A control of a panel: the labels and places that lead to it, from outside in, as they are given to ImGui.
struct Control {
    using Path = std::vector<std::variant<std::string, int>>;

    Control(const char* label)
        : path { label }
    {
    }
    Control(const std::string& label)
        : path { label }
    {
    }
    Control(Path steps, std::string inPanel = "side")
        : path(std::move(steps))
        , panel(std::move(inPanel))
    {
    }

    // These fail the test if there is no such panel.
    [[nodiscard]] ImGuiWindow* window() const;
    [[nodiscard]] ImGuiID id() const;

    Path path;
    std::string panel = "side";
};

}
