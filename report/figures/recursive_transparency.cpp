// Figures of transparency.
#include "report/figure.h"
#include "report/figures/ray_drawing.h"
#include "report/figures/seen_change.h"
#include "report/pictures.h"
#include "report/studio.h"
#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace report::recursive_transparency {
namespace {

    bool letsThrough(const HitInfo& hit)
    {
        return hit.material.transparency != 1.0f;
    }

    // Adds a scene without and with, and the reference's picture of it.
    Slider addOffAndOn(Sheet& sheet, Studio& studio, worker::RenderRequest request)
    {
        const worker::Rendering rendering = studio.render(Who::Submission, request);
        const Picture on = toPicture(studio.nameOf(Who::Submission) + ", with transparency", rendering);
        const Picture reference = toPicture("reference", studio.render(Who::Reference, request));
        const std::vector<Fact> facts = factsOf(request, rendering);
        sheet.facts.insert(sheet.facts.end(), facts.begin(), facts.end());
        sheet.facts.push_back(errorAgainst(reference, on));
        request.settings = { "transparency=false" };
        const Slider slider { toPicture("without", studio.render(Who::Submission, request)), on };
        sheet.panels.insert(sheet.panels.end(), { slider, reference });
        return slider;
    }

    Sheet drawOnAndOff(Studio& studio)
    {
        const auto panes = sceneNamed("transparency", { 520, 390 });
        Sheet sheet;
        const auto [without, with] = addOffAndOn(sheet, studio, panes);
        addOffAndOn(sheet, studio, sceneNamed("cornell_box_transparency", { 520, 390 }));
        const SeenChange change = seenChange(Stage(panes), without, with, letsThrough);
        sheet.claims = { claimOf(change, "Panes with alpha below 1") };
        sheet.data = { { "allowed", change.allowed }, { "within", change.within }, { "elsewhere", change.elsewhere } };
        return sheet;
    }

    // A surface that a ray goes through, and the sphere that is drawn there.
    struct Passage {
        glm::vec3 kd;
        float alpha;
        glm::vec3 drawn { std::numeric_limits<float>::quiet_NaN() }; // the sphere's colour, if there is one
    };

    std::vector<Passage> passagesOf(const worker::DebugRay& ray)
    {
        constexpr float near = 0.02f; // a few times the reach of a passthrough ray's offset
        std::vector<Passage> passages;
        for (const debug::Hit& hit : ray.hits) {
            if (!letsThrough(hit.hitInfo))
                continue;
            const glm::vec3 point = hit.ray.origin + hit.ray.t * hit.ray.direction;
            passages.push_back({ hit.hitInfo.material.kd, hit.hitInfo.material.transparency });
            for (const debug::DrawnSphere& sphere : drawnOf<debug::DrawnSphere>(ray))
                if (glm::distance(sphere.center, point) < near)
                    passages.back().drawn = sphere.color;
        }
        return passages;
    }

    std::string shown(const glm::vec3& color)
    {
        return color == color ? fmt::format("{:.3f}, {:.3f}, {:.3f}", color.x, color.y, color.z) : "none";
    }

    Table tableOf(const std::vector<Passage>& passages)
    {
        Table table { "the spheres' colours, from the camera on", { "kd", "alpha", "kd · alpha", "drawn" }, {} };
        for (const auto& [kd, alpha, drawn] : passages)
            table.rows.push_back({ shown(kd), fmt::format("{:.2f}", alpha), shown(kd * alpha), shown(drawn) });
        return table;
    }

    // Spheres larger than drawn: of their size they would be a pixel or two.
    Drawing rayDrawing(Studio& studio, Who who, const worker::RenderRequest& request, worker::DebugRay ray)
    {
        constexpr float enlargement = 8.0f;
        ray = onlyDrawn(std::move(ray), [](const debug::Shape& shape) {
            return shape.cause.way == debug::Way::Path
                && (std::holds_alternative<debug::DrawnRay>(shape.drawn)
                    || std::holds_alternative<debug::DrawnSphere>(shape.drawn));
        });
        for (debug::Shape& shape : ray.shapes)
            if (auto* sphere = std::get_if<debug::DrawnSphere>(&shape.drawn))
                sphere->radius *= enlargement;
        return toDrawing(fmt::format("{}; spheres {} times as large", studio.nameOf(who), enlargement), ray,
            studio.render(who, request));
    }

    Sheet drawDebugRay(Studio& studio)
    {
        auto request
            = sceneNamed("transparency", { 520, 390 }, { "accel_structure=false" }); // it draws spheres as well
        request.orbit = { 15, 60 };
        const glm::ivec2 throughAllPanes { 250, 206 };
        const worker::DebugRay ray = studio.followRay(Who::Submission, request, throughAllPanes);
        const worker::DebugRay expected = studio.followRay(Who::Reference, request, throughAllPanes);

        const std::vector<Passage> passages = passagesOf(ray);
        bool isRight = !passages.empty();
        float worst = 0.0f;
        Sheet sheet { .panels = { rayDrawing(studio, Who::Submission, request, ray),
                          rayDrawing(studio, Who::Reference, request, expected), tableOf(passages) } };
        for (const auto& [kd, alpha, drawn] : passages) {
            isRight &= isLike(drawn, kd * alpha);
            worst = std::max(worst, glm::distance(drawn, kd * alpha));
            sheet.data["distances"].push_back(glm::distance(drawn, kd * alpha));
        }
        sheet.facts = factsOfRay(request, throughAllPanes);
        sheet.claims
            = { { fmt::format("The ray goes through {} surfaces; the spheres' colours are at most {:.2g} from kd "
                              "· alpha.",
                      passages.size(), worst),
                isRight } };
        return sheet;
    }

    const Figure onAndOff(
        "transparency.on_and_off", "Scenes without and with transparency", Part::RenderedImages, drawOnAndOff);
    const Figure debugRay("transparency.debug", "What the code draws while a ray goes through three panes",
        Part::VisualDebugging, drawDebugRay);

}
}
