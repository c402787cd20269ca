#pragma once
#include <filesystem>
#include <string>

// The renderer as it is called.
namespace rendered {

extern const std::filesystem::path work; // a folder for what it writes

struct Outcome {
    int exitCode;
    std::string errors, output;
};

[[nodiscard]] std::string bytesOf(const std::filesystem::path& path);

// arguments: as a shell reads them.
Outcome render(const std::string& arguments);

}
