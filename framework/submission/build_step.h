#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace submission {

// Runs a compiler or a linker in a folder, locked in: it sees the system, that folder, and what is listed. What it
// prints goes to a file in that folder. Returns whether it came to an end, well or not, in a minute.
bool runBuildStep(const std::vector<std::string>& words, const std::filesystem::path& folder, const std::string& log,
    const std::vector<std::filesystem::path>& readable);

}
