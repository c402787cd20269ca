#include "app/rendered.h"
#include "submission/paths.h"
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <sys/wait.h>

namespace rendered {

namespace fs = std::filesystem;

const fs::path work = fs::path(submission::buildDirectory) / "tests" / "rendered";

std::string bytesOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return { std::istreambuf_iterator<char>(file), {} };
}

Outcome render(const std::string& arguments)
{
    fs::create_directories(work);
    const fs::path errors = work / "errors.txt", output = work / "output.txt";
    const std::string command = fmt::format("{}/framework/raywork-render {} > '{}' 2> '{}'", submission::buildDirectory,
        arguments, output.string(), errors.string());
    const int status = std::system(command.c_str());
    return { WEXITSTATUS(status), bytesOf(errors), bytesOf(output) };
}

}
