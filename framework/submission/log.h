#pragma once
#include <initializer_list>
#include <string>

// What a student has to see of what a compiler or linker printed: a dozen lines at most.
namespace submission {

// From the first error on.
[[nodiscard]] std::string compilerErrors(const std::string& log);

// What was found missing or twice.
[[nodiscard]] std::string linkerErrors(const std::string& log);

// The lines that hold any of the words.
[[nodiscard]] std::string linesWith(std::initializer_list<const char*> words, const std::string& log);

}
