#include "app/number_pairs.h"
#include <algorithm>
#include <cstdio>
#include <fmt/core.h>
#include <optional>
#include <stdexcept>

namespace app {
namespace {

    // Two numbers with a character between them.
    std::optional<glm::ivec2> parsePair(const std::string& text, char between)
    {
        glm::ivec2 pair { 0 };
        char found = 0, rest = 0;
        const bool isPair = std::sscanf(text.c_str(), "%d%c%d%c", &pair.x, &found, &pair.y, &rest) == 3;
        return isPair && found == between ? std::optional(pair) : std::nullopt;
    }

}

glm::ivec2 parseSize(const std::string& text)
{
    constexpr int largest = 32768;
    if (text.empty())
        return glm::ivec2(0);
    const auto size = parsePair(text, 'x');
    if (!size || std::min(size->x, size->y) < 1 || std::max(size->x, size->y) > largest)
        throw std::invalid_argument(
            fmt::format("--size: found '{}', expected WIDTHxHEIGHT, each 1 to {}", text, largest));
    return *size;
}

glm::ivec2 parseNumbers(const std::string& option, const std::string& text)
{
    const auto numbers = parsePair(text, ',');
    if (!numbers)
        throw std::invalid_argument(fmt::format("{}: found '{}', expected X,Y", option, text));
    return *numbers;
}

}
