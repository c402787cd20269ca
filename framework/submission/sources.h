#pragma once
#include "submission/part.h"
#include <filesystem>
#include <map>
#include <string>

namespace submission {

struct Source {
    Part part; // missing, taken or refused
    std::string text; // if taken
    std::string whyUntouched; // why there is nothing of its author's in it; empty if there is
};

// By file name without ".cpp": a feature, or an extension such as "extra/bloom".
using Sources = std::map<std::string, Source>;

// Reads the files of a submission that the interface names, and nothing else that lies beside them. Links, folders in
// place of files, and files of more than a megabyte are refused. Throws files::Error when the submission is no folder.
[[nodiscard]] Sources readSources(const std::filesystem::path& submission);

}
