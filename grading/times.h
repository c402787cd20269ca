#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace grading {

// What the parts of a grading took, in seconds.
struct Times {
    // Files go side by side, so theirs add up to more.
    struct OfFile {
        double compiling = 0.0, linking = 0.0;
        double asking = 0.0; // all checks of all features that the file is for
    };

    double building = 0.0, asking = 0.0, drawing = 0.0;
    std::map<std::string, OfFile> files; // of the submission, without .cpp
};

// {"building", "asking", "drawing", "files": {name: {"compiling", "linking", "asking"}}}. Not among a grade's outputs:
// equal submissions have equal grades, and how long a check took may tell what became of it.
void writeTimes(const std::filesystem::path& path, const Times& times);

}
