#pragma once
#include <filesystem>
#include <string>

namespace report {

// Pandoc's HTML of a Markdown text, formulas as MathML, its pictures inside. HTML in the text stays text. Only pictures
// that lie in the folder are shown. What was turned once is kept. Throws ProgramFailed.
[[nodiscard]] std::string toHtml(const std::string& markdown, const std::filesystem::path& folder);

}
