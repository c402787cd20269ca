#pragma once
#include "submission/part.h"
#include <filesystem>

namespace submission {

// Copies the sources of a submission, and nothing else that lies beside them, into another folder, without touching
// what is there already and the same. Links, folders in place of files, and files of more than a megabyte are refused.
// Throws files::Error when the submission is no folder.
[[nodiscard]] Parts takeSources(const std::filesystem::path& submission, const std::filesystem::path& destination);

}
