#include "gui/layout_file.h"
#include <cstdlib>
#include <filesystem>

namespace gui {

namespace fs = std::filesystem;

// As the XDG Base Directory Specification has it.
static fs::path settingsFolder()
{
    const char* const settings = std::getenv("XDG_CONFIG_HOME");
    if (settings && fs::path(settings).is_absolute())
        return settings;
    const char* const home = std::getenv("HOME");
    return home ? fs::path(home) / ".config" : fs::path();
}

std::string layoutFile()
{
    const fs::path folder = settingsFolder();
    std::error_code failed;
    if (folder.empty() || (fs::create_directories(folder / "raywork", failed), failed))
        return "";
    return (folder / "raywork" / "layout.ini").string();
}

}
