#pragma once
#include <filesystem>
#include <string>

namespace grading {

// What the grader is validated with lies below this folder of the build, one a process.
[[nodiscard]] std::filesystem::path validationFolder();

// reference/<file>.cpp
[[nodiscard]] std::filesystem::path referenceSource(const std::string& file);

void writeSource(const std::filesystem::path& path, const std::string& text);

// A submission: the reference with one file changed.
void writeChangedReference(const std::filesystem::path& folder, const std::string& file, const std::string& text);

}
