#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace grading {

// BLAKE2b of 256 bits: nobody finds two contents that share one.
using Hash = std::array<std::byte, 32>;

[[nodiscard]] Hash hashOf(std::span<const std::byte> bytes);

// Throws std::runtime_error when the file cannot be read.
[[nodiscard]] Hash hashOfFile(const std::filesystem::path& file);

// Of the names and contents of all files in a folder and below it.
[[nodiscard]] Hash hashOfFolder(const std::filesystem::path& folder);

[[nodiscard]] std::string toHex(const Hash& hash);

}
