#pragma once
#include <filesystem>
#include <string>

namespace report {

// Where a function is defined.
struct Location {
    std::string function;
    std::string file; // with ".cpp"; empty if it is nowhere
    int line = 0; // from 1
};

// In a folder's files, that one first: a submission may have it elsewhere.
[[nodiscard]] Location locate(
    const std::string& function, const std::filesystem::path& folder, const std::string& file);

}
