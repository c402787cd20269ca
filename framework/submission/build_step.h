#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace submission {

struct BuildStep {
    std::vector<std::string> words; // a compiler or a linker, and its arguments
    std::filesystem::path folder; // where it runs, and all that it may write to
    std::string log; // file in that folder for what it prints
    std::vector<std::filesystem::path> readable; // beside the system and that folder
};

enum class StepEnd {
    Succeeded,
    Failed, // by itself: it would again
    Stopped, // by a limit, or by a machine in trouble
};

// Runs the step locked in, for a minute at most.
[[nodiscard]] StepEnd run(const BuildStep& step);

}
