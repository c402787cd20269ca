#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace report {

// Gnuplot, Pandoc or Chromium is not there, or failed and said this.
class ProgramFailed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Runs a program until it ends, and returns what it printed. Throws ProgramFailed.
std::string runProgram(const std::vector<std::string>& words);

}
