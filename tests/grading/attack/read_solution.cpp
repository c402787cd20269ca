// crashed: looks for the solution, the checks and other submissions while it runs
#include <filesystem>
#include <stdexcept>
#include <string_view>

// Its own program is there, and so are the folders that this lies in.
static bool isAboveProgram(const std::string& path)
{
    return std::string_view("@BUILD@/").starts_with(path + "/");
}

static glm::vec3 attack()
{
    for (const char* path : { "@SOURCE@/reference", "@SOURCE@/grading/checks", "@SOURCE@/tests", "@BUILD@/grading/rows",
             "@BUILD@/grading/reference-worker", "/etc/passwd", "/root", "/home", "/var" })
        if (std::filesystem::exists(path) && !isAboveProgram(path))
            throw std::runtime_error(std::string("found ") + path);
    throw std::runtime_error("found nothing");
}
