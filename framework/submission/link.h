#pragma once
#include "submission/compile.h"
#include <vector>

namespace submission {

// A worker linked from objects of a submission and ours.
struct Program {
    std::string key; // of all that went into it
    std::filesystem::path file;
    std::string errors; // empty if it links
    double seconds = 0.0; // that it took; next to nothing if it was known
};

// rest: see Toolchain::restOf.
[[nodiscard]] Program link(const std::vector<Object>& objects, const std::string& rest);

}
