#pragma once
#include "report/probes/shading_question.h"
#include "report/studio.h"

namespace report {

// In the plane of the normal, that many degrees from it.
[[nodiscard]] inline glm::vec3 direction(double degrees)
{
    const double angle = glm::radians(degrees);
    return { static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(std::cos(angle)) };
}

[[nodiscard]] inline std::vector<glm::vec3> shade(
    Studio& studio, Who who, const std::vector<ShadingQuestion>& questions)
{
    return studio.ask<std::vector<glm::vec3>>(who, "figures.shading", questions);
}

// So many numbers with the same gaps between them.
[[nodiscard]] inline std::vector<double> evenly(double from, double to, int count)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(from + (to - from) * i / (count - 1));
    return values;
}

}
