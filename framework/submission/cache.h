#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace submission {

// Folders by the content that they were made from, kept from one run to the next. A folder appears whole or not at all
// and never changes, so any number of graders may share them.
//
// Returns the folder called key; makes it first if there is none: make fills an empty folder, and returns whether the
// result is worth keeping, that is, would come out the same again. Throws std::runtime_error when the disk is full.
[[nodiscard]] std::filesystem::path cached(
    const std::string& key, const std::function<bool(const std::filesystem::path&)>& make);

// Where graders keep what need not be made again: the build directory, or the folder that the environment's
// RAYWORK_CACHE names.
[[nodiscard]] std::filesystem::path keptFolder();

// The folder of all these folders.
[[nodiscard]] std::filesystem::path cacheFolder();

}
