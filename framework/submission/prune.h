#pragma once
#include <filesystem>

// Folders of things that can be made again.
namespace submission {

// Where a folder has more than maxEntries, removes all but the half of that number that were used last. What is in use
// is among them.
void prune(const std::filesystem::path& folder, std::size_t maxEntries);

// Where the files below a folder have more bytes than that, removes those that were not used for longest.
void pruneFiles(const std::filesystem::path& folder, std::uintmax_t mostBytes);

// Says that an entry is used now.
void noteUse(const std::filesystem::path& entry);

}
