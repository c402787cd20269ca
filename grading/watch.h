#pragma once
#include <filesystem>
#include <functional>

namespace grading {

// Calls onChange once and then again after each change of a source in the folder or below, for ever.
[[noreturn]] void watch(const std::filesystem::path& folder, const std::function<void()>& onChange);

}
