// What figures make of scenes and renderings: the free functions of studio.h.
#include "debug/false_color.h"
#include "report/pictures.h"
#include "report/studio.h"
#include "submission/paths.h"
#include "worker/load_request.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace report {

worker::RenderRequest sceneNamed(const std::string& name, glm::ivec2 size, std::vector<std::string> settings)
{
    const std::filesystem::path root = submission::sourceDirectory, file = name + ".toml";
    worker::RenderRequest request;
    request.scene = exists(root / "scenes" / file) ? root / "scenes" / file : root / "report" / "scenes" / file;
    request.size = size;
    request.settings = std::move(settings);
    return request;
}

Picture toPicture(std::string label, worker::Rendering rendering)
{
    return { std::move(label), rendering.size, std::move(rendering.pixels) };
}

Picture toFalseColors(std::string label, debug::Quantity quantity, worker::Rendering rendering)
{
    const debug::Range range = debug::rangeOf(quantity, rendering.pixels);
    return { std::move(label), rendering.size, debug::falseColors(quantity, std::move(rendering.pixels), range) };
}

Drawing toDrawing(std::string label, const worker::DebugRay& ray, const worker::Rendering& rendering)
{
    Picture picture { std::move(label), rendering.size, rendering.pixels };
    for (glm::vec3& pixel : picture.pixels) // so that what is drawn stands out
        pixel *= 0.5f;
    return { std::move(picture), strokesOf(ray.shapes, debug::Projection(ray.camera, ray.size)) };
}

Sheet againstReference(Studio& studio, const worker::RenderRequest& request)
{
    const worker::Rendering rendering = studio.render(Who::Submission, request);
    const Picture own = toPicture(studio.nameOf(Who::Submission), rendering);
    const Picture reference = toPicture(studio.nameOf(Who::Reference), studio.render(Who::Reference, request));
    Sheet sheet;
    sheet.columns = 1;
    sheet.panels = { Slider { reference, own } };
    sheet.facts = factsOf(request, rendering);
    sheet.facts.push_back(errorAgainst(reference, own));
    return sheet;
}

std::string samplesOf(const worker::RenderRequest& request)
{
    const auto [scene, config] = worker::load(request);
    const Features& features = config.features;
    const bool hasAreaLights = std::ranges::any_of(
        scene.lights, [](const auto& light) { return !std::holds_alternative<PointLight>(light); });
    const std::string samples = fmt::format("{} a pixel", features.numPixelSamples);
    return hasAreaLights ? samples + fmt::format(", {} a light", features.numShadowSamples) : samples;
}

std::vector<Fact> factsOf(const worker::RenderRequest& request)
{
    std::vector<Fact> facts {
        { "scene", std::filesystem::path(request.scene).filename().string() },
        { "size", fmt::format("{} × {}", request.size.x, request.size.y) },
    };
    if (!request.settings.empty())
        facts.push_back({ "settings", fmt::format("{}", fmt::join(request.settings, ", ")) });
    facts.push_back({ "samples", samplesOf(request) });
    facts.push_back({ "seed", "0" }); // renderImage's, of which each pixel makes its own
    return facts;
}

std::vector<Fact> factsOf(const worker::RenderRequest& request, const worker::Rendering& rendering)
{
    std::vector<Fact> facts = factsOf(request);
    if (rendering.numRays > 0) // they are counted
        facts.push_back({ "rays", fmt::format("{}", rendering.numRays) });
    facts.push_back({ "seconds", fmt::format("{:.2f}", rendering.seconds) });
    return facts;
}

}
