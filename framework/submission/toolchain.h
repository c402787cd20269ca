#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace submission {

// How submissions are built: what CMake wrote into rules.toml.
class Toolchain {
public:
    // Read once. Throws files::Error.
    [[nodiscard]] static const Toolchain& get();

    std::vector<std::string> compile; // the compiler and its flags
    std::vector<std::string> link;
    std::vector<std::string> symbols; // prints the names in an object
    std::vector<std::filesystem::path> folders; // of the compiler and of libraries that lie elsewhere than the system's
    // Changes with anything of ours that goes into an object or a program: flags, headers, archives.
    std::string digest;

    // What a program is linked with beside a submission's objects: rest is whole, questioned, stressed, figures, a
    // feature, or stressed_ and a feature.
    [[nodiscard]] std::vector<std::string> restOf(const std::string& rest) const;

    // Of what we built of such a rest and the digest above does not know.
    [[nodiscard]] std::string digestOfRest(const std::string& rest) const;

private:
    Toolchain();
};

}
