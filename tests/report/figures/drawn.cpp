#include "report/figures/drawn.h"
#include "files/scene_file.h"
#include "report/studio.h"
#include "submission/paths.h"
#include <algorithm>

namespace report_test {

report::Sheet drawn(const std::string& name)
{
    const auto reference = std::filesystem::path(submission::buildDirectory) / "report" / "reference-figures";
    const report::Subject subject { "somebody", reference, reference, {} };
    const auto& all = report::Figure::all();
    const auto figure = std::ranges::find(all, name, &report::Figure::name);
    if (figure == all.end())
        throw std::invalid_argument("no figure is called " + name);
    report::Studio studio { subject, figure->section };
    return figure->draw(studio);
}

std::string brokenClaim(const report::Sheet& sheet)
{
    for (const report::Claim& claim : sheet.claims)
        if (!claim.holds)
            return claim.text;
    return sheet.claims.empty() ? "nothing is claimed" : "";
}

debug::Projection projectionOf(const std::string& scene, glm::ivec2 size)
{
    Config config = files::loadSceneFile(std::string(RAYWORK_SCENES "/") + scene + ".toml").config;
    config.size = size;
    return { makeTrackball(config), size };
}

}
