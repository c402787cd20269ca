#pragma once
#include <functional>
#include <string_view>

namespace grading {

// Told what is being done, from any thread.
using OnProgress = std::function<void(std::string_view what)>;

}
