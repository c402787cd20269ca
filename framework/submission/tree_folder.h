#pragma once
#include <filesystem>

namespace submission {

// Where the code in this folder may keep trees of large scenes: a folder of its own, which is there, or no path if it
// cannot be made. Of all such folders together the files that were not used for longest go when they are too large.
//
// What is kept there is believed by whoever reads it, and the code can write there what it wants. So nobody else's
// pictures depend on it, and grades on none of them.
[[nodiscard]] std::filesystem::path treeFolder(const std::filesystem::path& submission);

}
