#pragma once
#include "submission/part.h"
#include <filesystem>
#include <string>

namespace submission {

// A source of a submission, compiled on its own against the interface.
struct Object {
    std::string key; // of its content and of all that it was compiled with
    std::filesystem::path file; // the object
    Part part; // built or refused
    double seconds = 0.0; // that it took; next to nothing if it was known
};

// name: without ".cpp", such as "texture" or "extra/bloom".
[[nodiscard]] Object compile(const std::string& name, const std::string& text);

}
