#pragma once
#include <filesystem>
#include <string>

namespace submission {

// The first of the undefined names in a list (as nm -uC prints it) that leads into the framework past the interface: a
// file can declare by hand what no header of the interface offers. Empty if there is none.
[[nodiscard]] std::string firstForeignSymbol(const std::filesystem::path& list);

}
