#pragma once
#include "values/needs_of.h"
#include "worker/explanation.h"

namespace worker {

// Of a picture by the code that is linked: in a worker.
[[nodiscard]] inline std::vector<ExplainedPart> explainNeeds(const Scene& scene, const Features& features)
{
    std::vector<ExplainedPart> parts;
    for (const values::Need& need : values::judgeNeeds(scene, features))
        parts.push_back({ need.part, need.why });
    return parts;
}

}
