// Figures of reflections.
#include "report/figure.h"
#include "report/figures/ray_drawing.h"
#include "report/figures/seen_change.h"
#include "report/pictures.h"
#include "report/plot.h"
#include "report/studio.h"
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace report::recursive {
namespace {

    // Transparency is off: behind glass a mirror would change what is no mirror.
    worker::RenderRequest spheres(const std::string& reflections)
    {
        return sceneNamed("spheres", { 520, 390 }, { "transparency=false", "reflections=" + reflections });
    }

    Sheet drawOnAndOff(Studio& studio)
    {
        const worker::RenderRequest request = spheres("true");
        const worker::Rendering rendering = studio.render(Who::Submission, request);
        const Picture without = toPicture("without", studio.render(Who::Submission, spheres("false")));
        const Picture with = toPicture(studio.nameOf(Who::Submission) + ", with reflections", rendering);
        const Picture reference = toPicture("reference", studio.render(Who::Reference, request));
        const SeenChange change = seenChange(
            Stage(request), without, with, [](const HitInfo& hit) { return hit.material.ks != glm::vec3(0.0f); });

        Sheet sheet { .panels = { Slider { without, with }, reference }, .facts = factsOf(request, rendering) };
        sheet.facts.push_back(errorAgainst(reference, with));
        sheet.claims = { claimOf(change, "Surfaces with ks above 0") };
        sheet.data = { { "within", change.within }, { "elsewhere", change.elsewhere } };
        return sheet;
    }

    // How much is missing at each depth.
    Plot plotOfErrors(const std::vector<double>& missing)
    {
        std::vector<std::vector<double>> rows;
        for (std::size_t depth = 0; depth < missing.size(); ++depth)
            rows.push_back({ static_cast<double>(depth), missing[depth] });
        return { "RMSE against depth 6",
            dataBlock("missing", rows)
                + "set logscale y; set xlabel 'depth'; set xrange [-0.5:5.5]; set format y '10^{%L}'; unset key\n"
                  "plot $missing using 1:2 with lines linetype 1, "
                + hoverPoints("missing", 1),
            { 340, 212 } };
    }

    Sheet drawDepths(Studio& studio)
    {
        constexpr int deepest = 6;
        Sheet sheet { .columns = 3 };
        std::vector<Picture> pictures;
        for (int depth = 0; depth <= deepest; ++depth) {
            const auto request = sceneNamed("reflections", { 340, 212 }, { fmt::format("max_depth={}", depth) });
            const worker::Rendering rendering = studio.render(Who::Submission, request);
            pictures.push_back(toPicture(fmt::format("depth {}", depth), rendering));
            if (depth == deepest) {
                sheet.facts = factsOf(request, rendering);
                sheet.facts.push_back(
                    errorAgainst(toPicture("reference", studio.render(Who::Reference, request)), pictures.back()));
            }
        }
        std::vector<double> missing;
        for (std::size_t depth = 0; depth < deepest; ++depth)
            missing.push_back(rmse(pictures[depth], pictures.back()));
        sheet.panels.assign(pictures.begin(), pictures.end());
        sheet.panels.emplace_back(plotOfErrors(missing));
        const bool shrinks = std::ranges::adjacent_find(missing, std::less_equal<>()) == missing.end();
        sheet.claims
            = { { fmt::format("Each reflection brings the picture closer to that of depth 6: without any it is "
                              "{:.2g} RMS away, at depth 5 {:.2g}.",
                      missing.front(), missing.back()),
                shrinks && missing.back() > 0.0 } };
        sheet.data = { { "missing", missing } };
        return sheet;
    }

    // How the first hit's mirrored ray leaves, in degrees from the normal.
    struct Angles {
        float in = 0.0f, out = 0.0f;
        std::size_t normals = 0, mirrored = 0, lights = 0; // rays drawn in those colours
    };

    float degreesBetween(const glm::vec3& a, const glm::vec3& b)
    {
        return glm::degrees(std::acos(glm::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0f, 1.0f)));
    }

    Angles anglesOf(const worker::DebugRay& ray)
    {
        Angles angles;
        const debug::Hit& first = ray.hits.at(0);
        angles.in = degreesBetween(-first.ray.direction, first.hitInfo.normal);
        for (const debug::DrawnRay& drawn : drawnOf<debug::DrawnRay>(ray)) {
            angles.normals += isLike(drawn.color, yellow);
            angles.lights += isLike(drawn.color, red);
            if (isLike(drawn.color, green)) // the last one drawn is the first hit's, as calls return
                angles.out = degreesBetween(drawn.ray.direction, first.hitInfo.normal), ++angles.mirrored;
        }
        return angles;
    }

    // Of rays only: boxes and triangles would hide them, and a way to a light is drawn over its direction.
    Drawing rayDrawing(Studio& studio, Who who, const worker::RenderRequest& request, const worker::DebugRay& ray)
    {
        const auto isShown = [](const debug::Shape& shape) {
            return std::holds_alternative<debug::DrawnRay>(shape.drawn) && shape.cause.way == debug::Way::Path;
        };
        return toDrawing(studio.nameOf(who), onlyDrawn(ray, isShown), studio.render(who, request));
    }

    Sheet drawDebugRay(Studio& studio)
    {
        auto request = figureScene("texture_in_mirror", { 520, 390 });
        request.orbit = { 60, 0 }; // from above
        const glm::ivec2 onMirror { 175, 215 };
        const worker::DebugRay ray = studio.followRay(Who::Submission, request, onMirror);
        const worker::DebugRay expected = studio.followRay(Who::Reference, request, onMirror);
        const Angles angles = anglesOf(ray);

        Sheet sheet { .panels = { rayDrawing(studio, Who::Submission, request, ray),
                          rayDrawing(studio, Who::Reference, request, expected) } };
        sheet.facts = factsOfRay(request, onMirror);
        sheet.claims
            = { { fmt::format("Drawn are {} normals in yellow, {} reflected rays in green and {} directions to "
                              "lights in red; the first ray comes in at {:.2f}° and leaves at {:.2f}°.",
                      angles.normals, angles.mirrored, angles.lights, angles.in, angles.out),
                angles.normals > 0 && angles.mirrored > 0 && angles.lights > 0
                    && std::abs(angles.in - angles.out) < 0.1f } };
        sheet.data = { { "normals", angles.normals }, { "mirrored", angles.mirrored }, { "lights", angles.lights },
            { "in", angles.in }, { "out", angles.out } };
        return sheet;
    }

    const Figure onAndOff(
        "reflection.on_and_off", "A scene without and with reflections", Part::RenderedImages, drawOnAndOff);
    const Figure debugRay(
        "reflection.debug", "What the code draws while it follows a ray", Part::VisualDebugging, drawDebugRay);
    const Figure depths("reflection.depth", "Depth 0 to 6 between two mirrors", Part::RenderedImages, drawDepths);

}
}
