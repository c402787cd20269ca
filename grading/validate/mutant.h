#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace grading {

// A source with one small change.
struct Mutant {
    int line; // where the change begins, from 1
    std::string original, changed; // code of the lines that it touches, in one line
    std::string text; // all of it
};

// All mutants of a source, in the order of the places that they change: relational operators, arithmetic, && and ||,
// min and max, true and false, numbers, components .x .y .z, ++ and --, statements left out, if conditions negated,
// functions that return at once. It knows C++ by its tokens alone: some mutants do not compile.
[[nodiscard]] std::vector<Mutant> mutantsOf(const std::string& source);

}
