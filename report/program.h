#pragma once
#include <string>
#include <vector>

namespace report {

// Runs a program until it ends, and returns what it printed. Throws std::runtime_error with that if it failed or is not
// there.
std::string runProgram(const std::vector<std::string>& words);

}
