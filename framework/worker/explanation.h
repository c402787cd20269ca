#pragma once
#include "worker/work.h"
#include <string>
#include <vector>

namespace worker {

struct ExplainedPart {
    std::string name;
    std::string whyNot; // it is left out; empty if it is not
};

// What the probe render.explain answers a RenderRequest: what the picture needs, and what was done for it.
struct Explanation {
    bool skips = true; // what it does not need is left out
    std::vector<ExplainedPart> parts;
    Work work;
    uint32_t numTextures = 0, numDecoded = 0;
};

// The words for it, wherever it is shown: what, and how much or why not.
struct ExplainedLine {
    std::string what, value;
};
[[nodiscard]] std::string titleOfNeeds(bool skips);
[[nodiscard]] std::vector<ExplainedLine> linesOf(const std::vector<ExplainedPart>& parts);
[[nodiscard]] std::vector<ExplainedLine> linesOf(const Work& work);
[[nodiscard]] std::vector<ExplainedLine> linesOfWork(const Explanation& explanation); // with what was decoded

inline Message& operator<<(Message& message, const ExplainedPart& p)
{
    return message << p.name << p.whyNot;
}

inline Reader& operator>>(Reader& reader, ExplainedPart& p)
{
    return reader >> p.name >> p.whyNot;
}

inline Message& operator<<(Message& message, const Explanation& e)
{
    return message << e.skips << e.parts << e.work << e.numTextures << e.numDecoded;
}

inline Reader& operator>>(Reader& reader, Explanation& e)
{
    return reader >> e.skips >> e.parts >> e.work >> e.numTextures >> e.numDecoded;
}

}
