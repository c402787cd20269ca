#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace submission {

// What a submission may include of ours: files and folders.
[[nodiscard]] std::vector<std::filesystem::path> interfaceHeaders();

// The first file of ours among those that a source in a folder was compiled from that a submission has no business
// with: anything in our source tree but the headers of the interface. Empty if there is none. dependencies: the file in
// which the compiler wrote them for make, if it came that far.
[[nodiscard]] std::string firstForeignInclude(const std::filesystem::path& folder, const std::string& dependencies);

}
