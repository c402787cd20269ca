#include "worker/explanation.h"

namespace worker {

std::string titleOfNeeds(bool skips)
{
    return skips ? "needed" : "needed, though nothing is left out: skipping is off";
}

std::vector<ExplainedLine> linesOf(const std::vector<ExplainedPart>& parts)
{
    std::vector<ExplainedLine> lines;
    for (const ExplainedPart& part : parts)
        lines.push_back({ part.name, part.whyNot.empty() ? "yes" : "no: " + part.whyNot });
    return lines;
}

std::vector<ExplainedLine> linesOf(const Work& work)
{
    return {
        { "rays from the camera", std::to_string(work.rays.camera) },
        { "rays mirrored or passed through", std::to_string(work.rays.bounced) },
        { "rays to lights", std::to_string(work.rays.shadow) },
        { "rays to lights, left out", std::to_string(work.rays.unlit) },
        { "nodes entered by the library", std::to_string(work.numNodes) },
        { "triangles tested", std::to_string(work.numTriangles) },
        { "textures looked up", std::to_string(work.numLookups) },
    };
}

std::vector<ExplainedLine> linesOfWork(const Explanation& explanation)
{
    std::vector<ExplainedLine> lines = linesOf(explanation.work);
    lines.push_back({ "textures decoded",
        std::to_string(explanation.numDecoded) + " of " + std::to_string(explanation.numTextures) });
    return lines;
}

}
