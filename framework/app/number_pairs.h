#pragma once
#include <glm/vec2.hpp>
#include <string>

namespace app {

// WIDTHxHEIGHT, each 1 to 32768; (0, 0) for an empty text. Throws std::invalid_argument.
[[nodiscard]] glm::ivec2 parseSize(const std::string& text);

// The option's X,Y. Throws std::invalid_argument.
[[nodiscard]] glm::ivec2 parseNumbers(const std::string& option, const std::string& text);

}
