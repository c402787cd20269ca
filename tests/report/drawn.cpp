#include "report/drawn.h"
#include "report/studio.h"
#include <algorithm>
#include <files/scene_file.h>

namespace tests {
namespace {

    report::Sheet draw(const std::string& name, const char* submission)
    {
        const report::Subject subject { "somebody", submission, RAYWORK_REFERENCE_FIGURES, {} };
        const auto& all = report::Figure::all();
        const auto figure = std::ranges::find(all, name, &report::Figure::name);
        if (figure == all.end())
            throw std::invalid_argument("no figure is called " + name);
        report::Studio studio { subject, figure->section };
        return figure->draw(studio);
    }

}

report::Sheet drawn(const std::string& figure)
{
    return draw(figure, RAYWORK_REFERENCE_FIGURES);
}

std::string brokenClaim(const report::Sheet& sheet)
{
    for (const report::Claim& claim : sheet.claims)
        if (!claim.holds)
            return claim.text;
    return sheet.claims.empty() ? "nothing is claimed" : "";
}

std::string notWritten(const std::string& figure)
{
    try {
        (void)draw(figure, RAYWORK_STUDENT_FIGURES);
        return {};
    } catch (const report::NotWritten& stubs) {
        return stubs.what();
    }
}

debug::Projection projectionOf(const std::string& scene, glm::ivec2 size)
{
    Config config = files::loadSceneFile(std::string(RAYWORK_SCENES "/") + scene + ".toml").config;
    config.size = size;
    return { makeTrackball(config), size };
}

}
