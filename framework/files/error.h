#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>

namespace files {

// Bad input: what() reads "file:line: message", without a line "file: message". The message says what was found and
// what was expected.
class Error : public std::runtime_error {
public:
    Error(const std::filesystem::path& file, const std::string& message);
    Error(const std::filesystem::path& file, int line, const std::string& message);
};

}
