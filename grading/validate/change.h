#pragma once
#include "grading/validate/token.h"
#include <cstddef>
#include <string>
#include <vector>

namespace grading {

// A piece of a source and what takes its place.
struct Change {
    std::size_t at, length;
    std::string replacement;
};

// Other operators, names and numbers in place of single tokens.
[[nodiscard]] std::vector<Change> changesOfTokens(std::string_view source, const std::vector<Token>& tokens);

// Statements left out, conditions negated, functions that return at once.
[[nodiscard]] std::vector<Change> changesOfStatements(std::string_view source, const std::vector<Token>& tokens);

}
