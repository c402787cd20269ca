#include "files/error.h"

namespace files {

Error::Error(const std::filesystem::path& file, const std::string& message)
    : std::runtime_error(file.string() + ": " + message)
{
}

Error::Error(const std::filesystem::path& file, int line, const std::string& message)
    : std::runtime_error(file.string() + ":" + std::to_string(line) + ": " + message)
{
}

}
