#pragma once
#include <fmt/format.h>
#include <framework/ray.h>
#include <glm/vec3.hpp>
#include <string>

namespace stress {

// Numbers as they are: nine digits tell every float from every other, and seventeen every double.
[[nodiscard]] inline std::string exactly(float value)
{
    return fmt::format("{:.9g}", value);
}

[[nodiscard]] inline std::string exactly(double value)
{
    return fmt::format("{:.17g}", value);
}

template <int N, typename T> [[nodiscard]] std::string exactly(const glm::vec<N, T>& values)
{
    std::string text;
    for (int i = 0; i < N; ++i)
        text += (i == 0 ? "(" : ", ") + exactly(values[i]);
    return text + ")";
}

[[nodiscard]] inline std::string exactly(const Ray& ray)
{
    return fmt::format(
        "the ray from {} along {} to t = {}", exactly(ray.origin), exactly(ray.direction), exactly(ray.t));
}

}
