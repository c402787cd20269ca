#pragma once
#include <filesystem>

namespace report {

// Prints a page by Chromium. Throws ProgramFailed.
void printPdf(const std::filesystem::path& page, const std::filesystem::path& pdf);

}
