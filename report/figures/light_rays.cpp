// The shadow rays of one point that sees a part of an area light.
#include "report/figure.h"
#include "report/pictures.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report {
namespace {

    constexpr glm::ivec2 size { 520, 390 };
    constexpr glm::ivec2 pixel { 150, 120 }; // in the border of the sphere's shadow

    // A submission that has a visibilityOfLightSample of its own draws them itself: then all that it draws is taken.
    std::vector<debug::Shape> shadowRaysOf(const worker::DebugRay& ray)
    {
        std::vector<debug::Shape> onTheWay;
        std::ranges::copy_if(ray.shapes, std::back_inserter(onTheWay),
            [](const debug::Shape& shape) { return shape.cause.way == debug::Way::Shadow; });
        return onTheWay.empty() ? ray.shapes : onTheWay;
    }

    struct Counts {
        int green = 0, red = 0;

        [[nodiscard]] double greenShare() const { return green / std::max(1.0, static_cast<double>(green + red)); }
    };

    Counts countColors(const std::vector<debug::Shape>& shapes)
    {
        Counts counts;
        for (const debug::Shape& shape : shapes)
            if (const auto* drawn = std::get_if<debug::DrawnRay>(&shape.drawn)) {
                counts.green += drawn->color.g > drawn->color.r;
                counts.red += drawn->color.r > drawn->color.g;
            }
        return counts;
    }

    // From the camera, or from the side.
    worker::RenderRequest requestOf(glm::vec2 orbit, std::vector<std::string> settings = {})
    {
        settings.emplace_back("shadow_samples=32");
        worker::RenderRequest request = sceneNamed("light_parallelogram", size, std::move(settings));
        request.orbit = orbit;
        return request;
    }

    Drawing drawFrom(Studio& studio, Who who, const std::string& label, glm::vec2 orbit)
    {
        worker::DebugRay ray = studio.followRay(who, requestOf(orbit), pixel);
        ray.shapes = shadowRaysOf(ray);
        return toDrawing(label, ray, studio.render(who, requestOf(orbit)));
    }

    Sheet drawRays(Studio& studio)
    {
        const worker::DebugRay ray = studio.followRay(Who::Submission, requestOf({}), pixel);
        const Counts counts = countColors(shadowRaysOf(ray));
        const worker::DebugRay lit = studio.followRay(Who::Submission, requestOf({}, { "shadows=false" }), pixel);
        const double visible = ray.color.y / lit.color.y;
        const std::string name = studio.nameOf(Who::Submission);
        Sheet sheet;
        sheet.panels = { drawFrom(studio, Who::Submission, name, { 0, 0 }),
            drawFrom(studio, Who::Submission, name + ", from the side", { -25, 55 }),
            drawFrom(studio, Who::Reference, "reference", { 0, 0 }),
            drawFrom(studio, Who::Reference, "reference, from the side", { -25, 55 }) };
        sheet.facts = { { "scene", "light_parallelogram.toml" }, { "pixel", fmt::format("{}, {}", pixel.x, pixel.y) },
            { "samples", "1 a pixel, 32 a light" }, { "seed", "1" } };
        sheet.claims = {
            { fmt::format("{} rays reach the light (green), {} are blocked (red); the point has {:.0f} % of "
                          "the brightness that it has without shadows, and {:.0f} % of the rays are green.",
                  counts.green, counts.red, 100.0 * visible, 100.0 * counts.greenShare()),
                counts.green > 0 && counts.red > 0 && std::abs(visible - counts.greenShare()) < 0.1 }
        }; // the light is brighter at one end
        sheet.data = { { "green", counts.green }, { "red", counts.red }, { "visible", visible } };
        return sheet;
    }

    const Figure rays("light.shadow_rays", "Shadow rays: green where the light is visible, red where not", drawRays);

}
}
