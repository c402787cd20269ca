#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace report {

// A figure for the page, of what figure_file.h describes. folder: where its files lie; again: how to draw it again.
[[nodiscard]] std::string toHtml(
    const nlohmann::json& figure, const std::filesystem::path& folder, const std::string& again);

}
