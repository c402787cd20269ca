#include "submission/named_folder.h"
#include "submission/paths.h"

namespace submission {

std::filesystem::path namedFolder(const std::string& name)
{
    if (name == "student" || name == "reference")
        return std::filesystem::path(sourceDirectory) / name;
    return name;
}

}
