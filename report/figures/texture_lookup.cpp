// Figures of single lookups: of a hit that the camera sees, and of one that it sees in a mirror.
#include "report/figure.h"
#include "report/figures/ray_drawing.h"
#include "report/figures/stage.h"
#include "report/figures/texture_space.h"
#include "report/studio.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace report::texture_lookup {
namespace {

    // The first lookup on the path that deep. Without one there is nothing to show, perhaps for want of other
    // functions.
    worker::TextureLookup lookupAt(const Studio& studio, const worker::DebugRay& ray, int bounce)
    {
        const auto isIt = [&](const worker::TextureLookup& lookup) {
            return lookup.cause == debug::Cause { static_cast<int16_t>(bounce), debug::Way::Path };
        };
        const auto found = std::ranges::find_if(ray.lookups, isIt);
        if (found == ray.lookups.end() && !studio.stubs().empty())
            throw NotWritten(studio.stubs());
        if (found == ray.lookups.end())
            throw std::runtime_error(fmt::format("no texture is looked up where the ray has turned {} times", bounce));
        return *found;
    }

    nlohmann::json toJson(const worker::TextureLookup& lookup)
    {
        nlohmann::json texels = nlohmann::json::array();
        for (const debug::Texel& texel : lookup.texels)
            texels.push_back({ texel.index.x, texel.index.y, texel.weight });
        return { { "place",
                     { lookup.texCoord.x * static_cast<float>(lookup.size.x),
                         lookup.texCoord.y * static_cast<float>(lookup.size.y) } },
            { "bounce", lookup.cause.bounce }, { "texels", texels } };
    }

    bool isBilinear(const worker::TextureLookup& lookup)
    {
        constexpr float tolerance = 1e-3f; // texels below a weight of 1e-4 are not told
        return lookup.texels.size() <= 4 && std::abs(sumOfWeights(lookup) - 1.0f) < tolerance
            && distanceOfMean(lookup) < tolerance;
    }

    Sheet drawLookup(Studio& studio)
    {
        const glm::ivec2 size { 520, 348 }, pixel { 199, 232 };
        const auto ask = [&](const std::string& bilinear) {
            const auto request = sceneNamed("texture_nearest", size, { "bilinear_filtering=" + bilinear });
            return lookupAt(studio, studio.followRay(Who::Submission, request, pixel), 0);
        };
        const worker::TextureLookup nearest = ask("false"), bilinear = ask("true");
        const Stage stage { sceneNamed("texture_nearest", size) };
        Sheet sheet { .panels
            = { textureSpace("nearest", nearest, stage.scene()), textureSpace("bilinear", bilinear, stage.scene()) },
            .facts = factsOfRay(sceneNamed("texture_nearest", size), pixel) };
        sheet.claims
            = { { fmt::format("Nearest takes {} texel; bilinear takes {}, with weights whose sum is {:.4f}; the "
                              "mean of their centres is {:.1g} texels from the hit.",
                      nearest.texels.size(), bilinear.texels.size(), sumOfWeights(bilinear), distanceOfMean(bilinear)),
                nearest.texels.size() == 1 && isBilinear(bilinear) } };
        sheet.data = { { "nearest", toJson(nearest) }, { "bilinear", toJson(bilinear) } };
        return sheet;
    }

    Drawing fromAbove(Studio& studio, const worker::RenderRequest& request, worker::DebugRay ray)
    {
        ray = onlyDrawn(std::move(ray), [](const debug::Shape& shape) {
            return std::holds_alternative<debug::DrawnRay>(shape.drawn) && shape.cause.way == debug::Way::Path;
        });
        return toDrawing("the ray, seen from above", ray, studio.render(Who::Submission, request));
    }

    Sheet drawSecondary(Studio& studio)
    {
        const glm::ivec2 size { 520, 400 }, inMirror { 175, 215 };
        auto request = figureScene("texture_in_mirror", size);
        request.orbit = { 60, 0 };
        const worker::DebugRay ray = studio.followRay(Who::Submission, request, inMirror);
        const worker::TextureLookup lookup = lookupAt(studio, ray, 1);
        Sheet sheet { .panels = { fromAbove(studio, request, ray),
                          textureSpace("the hit in the mirror, bilinear", lookup, Stage(request).scene()) },
            .facts = factsOfRay(request, inMirror) };
        sheet.claims
            = { { fmt::format("The ray meets the mirror, and the texture after its first turn: {} texels took part, "
                              "with weights whose sum is {:.4f}.",
                      lookup.texels.size(), sumOfWeights(lookup)),
                isBilinear(lookup) } };
        sheet.data = toJson(lookup);
        return sheet;
    }

    const Figure lookup(
        "texture.lookup", "A hit in texture space, with the texels that took part", Part::VisualDebugging, drawLookup);
    const Figure secondary(
        "texture.secondary", "A hit in a mirror, in texture space", Part::VisualDebugging, drawSecondary);

}
}
