#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace report {

// Text as it is, for an element or an attribute.
[[nodiscard]] std::string escaped(std::string_view text);

// A picture's file as an address that holds it. Throws files::Error.
[[nodiscard]] std::string dataUri(const std::filesystem::path& path);

// A plot by gnuplot, to stand in a page: in the page's ink, and with ids that no other plot has.
[[nodiscard]] std::string inlinePlot(const std::filesystem::path& svg, const std::string& label);

}
