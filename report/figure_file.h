#pragma once
#include "report/sheet.h"
#include <filesystem>
#include <nlohmann/json.hpp>

namespace report {

// What is kept of a figure in OUT/figures: <name>.json and, beside it, its pictures, <name>.<panel>.png, and .svg of
// drawings and plots. The page is made from these files alone:
//   {"name", "title", "part", "key", "state": "drawn", "not written" or "failed", "message": of the latter two,
//    "columns", "panels": [{"kind": "picture", "drawing" or "plot", "label", "png", "svg", "width", "height"},
//                          {"kind": "slider", "before": a picture, "after": a picture},
//                          {"kind": "table", "label", "head", "rows"}],
//    "facts": [[name, value]], "claims": [{"text", "holds"}], "stubs": [function], "data"}
// Sizes are those of the PNG in pixels.

// Writes a sheet's pictures and returns "columns", "panels", "facts", "claims" and "data". Throws
// files::Error and ProgramFailed.
[[nodiscard]] nlohmann::json saveSheet(
    const std::filesystem::path& folder, const std::string& name, const Sheet& sheet);

}
