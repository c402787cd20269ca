// The shadow rays of one point that sees a part of an area light.
#include "debug/projection.h"
#include "files/scene_file.h"
#include "report/figure.h"
#include "report/figures/ray_drawing.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::light_rays {
namespace {

    constexpr glm::ivec2 size { 520, 390 };
    const glm::vec3 pointInBorder { 0.755f, -0.3f, -0.27f }; // of the ball's shadow on the ground

    // What is drawn on the way to a light, but for the boxes of the tree. A submission that has a
    // visibilityOfLightSample of its own draws shadow rays itself: then all of its rays are taken.
    std::vector<debug::Shape> shadowRaysOf(const worker::DebugRay& ray)
    {
        std::vector<debug::Shape> rays;
        std::ranges::copy_if(ray.shapes, std::back_inserter(rays), [](const debug::Shape& shape) {
            return std::holds_alternative<debug::DrawnRay>(shape.drawn)
                || std::holds_alternative<debug::DrawnSphere>(shape.drawn);
        });
        std::vector<debug::Shape> onTheWay;
        std::ranges::copy_if(rays, std::back_inserter(onTheWay),
            [](const debug::Shape& shape) { return shape.cause.way == debug::Way::Shadow; });
        return onTheWay.empty() ? rays : onTheWay;
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

    worker::RenderRequest requestOf(glm::vec2 orbit = {}, std::vector<std::string> settings = {})
    {
        worker::RenderRequest request = sceneNamed("shadow_rays", size, std::move(settings));
        request.orbit = orbit;
        return request;
    }

    glm::ivec2 pixelInBorder()
    {
        Config config = files::loadSceneFile(requestOf().scene).config;
        config.size = size;
        return glm::ivec2(debug::Projection(makeTrackball(config), size).point(pointInBorder).value());
    }

    Drawing drawFrom(Studio& studio, Who who, const std::string& label, glm::vec2 orbit)
    {
        worker::DebugRay ray = studio.followRay(who, requestOf(orbit), pixelInBorder());
        ray.shapes = shadowRaysOf(ray);
        return toDrawing(label, ray, studio.render(who, requestOf(orbit)));
    }

    Sheet drawRays(Studio& studio)
    {
        const glm::ivec2 pixel = pixelInBorder();
        const worker::DebugRay ray = studio.followRay(Who::Submission, requestOf(), pixel);
        const Counts counts = countColors(shadowRaysOf(ray));
        const worker::DebugRay lit = studio.followRay(Who::Submission, requestOf({}, { "shadows=false" }), pixel);
        const double visible = ray.color.y / lit.color.y;
        const std::string name = studio.nameOf(Who::Submission);
        const glm::vec2 front { 0, 0 }, above { 45, 30 };
        Sheet sheet;
        sheet.panels = { drawFrom(studio, Who::Submission, name, front),
            drawFrom(studio, Who::Submission, name + ", from above", above),
            drawFrom(studio, Who::Reference, "reference", front),
            drawFrom(studio, Who::Reference, "reference, from above", above) };
        sheet.facts = factsOfRay(requestOf(), pixel);
        sheet.claims = {
            { fmt::format("{} rays reach the light (green), {} are blocked (red); the point has {:.0f} % of "
                          "the brightness that it has without shadows, and {:.0f} % of the rays are green.",
                  counts.green, counts.red, 100.0 * visible, 100.0 * counts.greenShare()),
                counts.green > 0 && counts.red > 0 && std::abs(visible - counts.greenShare()) < 0.1 }
        }; // light comes in at angles that differ a little
        sheet.data = { { "green", counts.green }, { "red", counts.red }, { "visible", visible } };
        return sheet;
    }

    const Figure rays("light.shadow_rays", "Shadow rays: green where the light is visible, red where not",
        Part::VisualDebugging, drawRays);

}
}
