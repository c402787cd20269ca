#pragma once
#include <array>
#include <filesystem>
#include <optional>

namespace gui {

// Which file is open, and which one is to be.
class ScenePanel {
public:
    // In the current ImGui window. Returns the file that was picked now: one of the scenes, or one by its path.
    [[nodiscard]] std::optional<std::filesystem::path> pick(const std::filesystem::path& open);

private:
    std::array<char, 4096> m_typed {}; // a path
};

}
