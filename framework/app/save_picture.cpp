#include "app/save_picture.h"
#include "files/error.h"
#include "submission/paths.h"
#include <csignal>
#include <cstdio>
#include <string>

namespace app {

namespace fs = std::filesystem;

// A shell's word with any text in it.
static std::string quoted(const std::string& text)
{
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

void checkPictureName(const fs::path& path)
{
    const fs::path extension = path.extension();
    if (extension != ".png" && extension != ".exr")
        throw files::Error(path, "found a picture of type '" + extension.string() + "', expected .png or .exr");
}

void savePicture(const fs::path& path, glm::ivec2 size, std::span<const glm::vec3> pixels)
{
    std::signal(SIGPIPE, SIG_IGN); // a process that is gone shows in its exit code
    const fs::path program = fs::path(submission::buildDirectory) / "framework" / "raywork-picture";
    std::FILE* const pipe = popen((quoted(program.string()) + " " + quoted(path.string())).c_str(), "w");
    if (!pipe)
        throw files::Error(program, "cannot be started");
    std::fwrite(&size, sizeof(size), 1, pipe);
    std::fwrite(pixels.data(), sizeof(glm::vec3), pixels.size(), pipe);
    if (pclose(pipe) != 0)
        throw PictureNotSaved();
}

}
