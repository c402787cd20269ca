#pragma once
#include <filesystem>
#include <string>

namespace submission {

// The first name in an object (a list as readelf prints it) that leads into the framework past the interface, or stands
// in for a part of the worker: a file can declare by hand what no header of the interface offers. Empty if there is
// none.
[[nodiscard]] std::string firstForeignSymbol(const std::filesystem::path& list);

}
