#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace grading {

// The reference with one file changed.
struct Solution {
    std::string file; // without .cpp
    std::string name; // unique among those of the file
    std::set<std::string> costs; // features that must lose points, and no other may; none if the solution is right
    std::string text; // of the file

    [[nodiscard]] std::string title() const { return file + ": " + name; }
};

struct Bank {
    std::vector<Solution> wrong, accepted; // in the order of the files' names
};

// <folder>/wrong/<file>.toml holds [[wrong]] name, costs, why, and replace = [[from, to], ...] or file;
// <folder>/accepted/<file>.toml holds [[accepted]] with name, and replace or file.
// replace: each `from` stands exactly once in reference/<file>.cpp. file: lies beside the TOML and takes the place of
// reference/<file>.cpp. why: wanted where other features than the file's own lose points. Throws files::Error.
[[nodiscard]] Bank loadBank(const std::filesystem::path& folder);

}
