#pragma once
#include "grading/validate/mutant.h"
#include <filesystem>
#include <string>
#include <vector>

namespace grading {

// In place of a changed line: whatever becomes of the original.
inline constexpr const char* anyChange = "*";

// A mutant that is as right as the original, and why.
struct Survivor {
    std::string file; // of the reference, without .cpp
    std::string original, changed; // as in Mutant
    std::string why;
    int line; // in the list

    [[nodiscard]] bool is(const Mutant& mutant) const
    {
        return original == mutant.original && (changed == anyChange || changed == mutant.changed);
    }
};

// [[survivor]] file, line_text, mutant_text, why. A missing list is an empty one. Throws files::Error.
[[nodiscard]] std::vector<Survivor> loadSurvivors(const std::filesystem::path& list);

}
