#pragma once
#include <filesystem>

namespace report {

// Prints a page by Chromium. Throws std::runtime_error.
void printPdf(const std::filesystem::path& page, const std::filesystem::path& pdf);

}
