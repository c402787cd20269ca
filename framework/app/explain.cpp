#include "app/explain.h"
#include <fmt/core.h>

namespace app {

static void printCount(const char* what, uint64_t count)
{
    fmt::print("  {:<32} {:>12}\n", what, count);
}

void explain(const worker::Explanation& explanation)
{
    fmt::print("{}\n", explanation.skips ? "needed" : "needed, though nothing is left out: skipping is off");
    for (const worker::ExplainedPart& part : explanation.parts)
        fmt::print("  {:<32} {}\n", part.name, part.whyNot.empty() ? "yes" : "no: " + part.whyNot);
    fmt::print("done\n");
    printCount("rays from the camera", explanation.rays.camera);
    printCount("rays mirrored or passed through", explanation.rays.bounced);
    printCount("rays to lights", explanation.rays.shadow);
    printCount("rays to lights, left out", explanation.rays.unlit);
    printCount("nodes entered by the library", explanation.numNodes);
    printCount("triangles tested", explanation.numTriangles);
    printCount("textures looked up", explanation.numLookups);
    fmt::print("  {:<32} {:>12} of {}\n", "textures decoded", explanation.numDecoded, explanation.numTextures);
}

}
