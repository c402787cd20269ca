#include "app/rendered.h"
#include "submission/paths.h"
#include <cstdlib>
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
    const std::string program = std::string(submission::buildDirectory) + "/framework/raywork-render ";
    const int status
        = std::system((program + arguments + " > '" + output.string() + "' 2> '" + errors.string() + "'").c_str());
    return { WEXITSTATUS(status), bytesOf(errors), bytesOf(output) };
}

}
