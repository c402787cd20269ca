// Figures of what the traversal draws: the boxes in their order, and the triangle that was hit.
#include "report/figure.h"
#include "report/figures/ray_drawing.h"
#include "report/figures/stage.h"
#include "report/pictures.h"
#include "report/studio.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace report::bvh {
namespace {

    // The ray through this pixel, as a part of the picture, meets the forehead and then the back of the head.
    constexpr glm::ivec2 size { 520, 520 }, pixel { 200, 305 };

    // The larger, the more pixels.
    worker::RenderRequest monkeyFromTheSide(int scale)
    {
        auto request = sceneNamed("monkey", scale * size);
        request.orbit = { 12, 35 };
        return request;
    }

    // Without what belongs to lights.
    worker::DebugRay followRay(Studio& studio, Who who, int scale)
    {
        return onlyDrawn(studio.followRay(who, monkeyFromTheSide(scale), scale * pixel), [](const debug::Shape& shape) {
            const auto* const ray = std::get_if<debug::DrawnRay>(&shape.drawn);
            return shape.cause.way == debug::Way::Path && !(ray && isLike(ray->color, red));
        });
    }

    // The boxes' colours in the order visited.
    Picture strip(const std::vector<debug::DrawnBox>& boxes)
    {
        const glm::ivec2 cells { std::max<int>(static_cast<int>(boxes.size()), 1), 1 };
        Picture picture { "the boxes' colours in the order visited", cells, {} };
        for (const debug::DrawnBox& box : boxes)
            picture.pixels.push_back(box.color);
        picture.pixels.resize(static_cast<std::size_t>(cells.x), glm::vec3(0.0f));
        return magnified(picture, std::max(1, size.x / cells.x));
    }

    // From yellow to red: green never rises, and falls all the way.
    bool isYellowToRed(const std::vector<debug::DrawnBox>& boxes)
    {
        const auto greenRises
            = [](const debug::DrawnBox& a, const debug::DrawnBox& b) { return b.color.y > a.color.y; };
        return boxes.size() > 1 && isLike(boxes.front().color, yellow) && isLike(boxes.back().color, red)
            && std::ranges::adjacent_find(boxes, greenRises) == boxes.end();
    }

    worker::DebugRay boxesAndRay(Studio& studio, Who who)
    {
        return onlyDrawn(followRay(studio, who, 1),
            [](const debug::Shape& shape) { return !std::holds_alternative<debug::DrawnTriangle>(shape.drawn); });
    }

    Drawing drawnBy(Studio& studio, Who who, const worker::DebugRay& ray, int scale)
    {
        return toDrawing(studio.nameOf(who), ray, studio.render(who, monkeyFromTheSide(scale)));
    }

    Sheet drawOrder(Studio& studio)
    {
        const worker::DebugRay ray = boxesAndRay(studio, Who::Submission);
        const worker::DebugRay expected = boxesAndRay(studio, Who::Reference);
        const auto boxes = drawnOf<debug::DrawnBox>(ray), theirs = drawnOf<debug::DrawnBox>(expected);

        Sheet sheet { .panels = { drawnBy(studio, Who::Submission, ray, 1),
                          drawnBy(studio, Who::Reference, expected, 1), strip(boxes), strip(theirs) },
            .facts = factsOfRay(monkeyFromTheSide(1), pixel) };
        std::vector<float> greens;
        for (const debug::DrawnBox& box : boxes)
            greens.push_back(box.color.y);
        sheet.claims = { { fmt::format("{} boxes are visited, the reference visits {}. From yellow to red their green "
                                       "goes {:.2f}.",
                               boxes.size(), theirs.size(), fmt::join(greens, ", ")),
            isYellowToRed(boxes) } };
        sheet.data = { { "green", greens } };
        return sheet;
    }

    // The triangles are small: a part of a larger picture.
    constexpr int magnification = 2;
    constexpr glm::ivec2 lowerLeft { 200, 400 };

    bool isOf(const debug::DrawnTriangle& drawn, const Crossing& crossing)
    {
        return drawn.v0 == crossing.primitive.v0 && drawn.v1 == crossing.primitive.v1
            && drawn.v2 == crossing.primitive.v2;
    }

    // What is in the ray's way further on, as outlines, and the way on.
    void addCrossings(worker::DebugRay& ray, const std::vector<Crossing>& crossings)
    {
        const glm::vec3 blue { 0.35f, 0.7f, 0.9f };
        const Ray first = ray.hits.at(0).ray;
        const auto add = [&](const glm::vec3& from, const glm::vec3& to) {
            ray.shapes.push_back({ debug::DrawnRay { { from, to - from, 1.0f }, blue }, {} });
        };
        for (std::size_t i = 1; i < crossings.size(); ++i) {
            const auto& [primitive, t] = crossings[i];
            add(primitive.v0.position, primitive.v1.position);
            add(primitive.v1.position, primitive.v2.position);
            add(primitive.v2.position, primitive.v0.position);
            add(first.origin + crossings[i - 1].t * first.direction, first.origin + t * first.direction);
        }
    }

    worker::DebugRay trianglesAndRay(Studio& studio, Who who)
    {
        return onlyDrawn(followRay(studio, who, magnification), [](const debug::Shape& shape) {
            return std::holds_alternative<debug::DrawnTriangle>(shape.drawn)
                || std::holds_alternative<debug::DrawnRay>(shape.drawn);
        });
    }

    Drawing hitDrawnBy(Studio& studio, Who who, worker::DebugRay ray, const std::vector<Crossing>& crossings)
    {
        addCrossings(ray, crossings);
        return crop(drawnBy(studio, who, ray, magnification), lowerLeft, size);
    }

    Sheet drawHit(Studio& studio)
    {
        const auto crossings = Stage(monkeyFromTheSide(magnification)).crossings(magnification * pixel);
        const worker::DebugRay ray = trianglesAndRay(studio, Who::Submission);
        const worker::DebugRay expected = trianglesAndRay(studio, Who::Reference);
        const auto triangles = drawnOf<debug::DrawnTriangle>(ray);

        Sheet sheet { .panels = { hitDrawnBy(studio, Who::Submission, ray, crossings),
                          hitDrawnBy(studio, Who::Reference, expected, crossings) },
            .facts = factsOfRay(monkeyFromTheSide(magnification), magnification * pixel) };
        std::vector<float> distances;
        std::vector<std::size_t> drawn;
        for (const Crossing& crossing : crossings) {
            distances.push_back(crossing.t);
            if (std::ranges::any_of(triangles, [&](const auto& triangle) { return isOf(triangle, crossing); }))
                drawn.push_back(distances.size());
        }
        sheet.claims = { { fmt::format("The ray's way leads through {} triangles, at t = {:.2f}. The code draws {}, in "
                                       "white: number {}. The outlines in blue are the report's.",
                               distances.size(), fmt::join(distances, ", "), triangles.size(), fmt::join(drawn, ", ")),
            triangles.size() == 1 && drawn == std::vector<std::size_t> { 1 } && distances.size() > 1 } };
        sheet.data = { { "t", distances }, { "drawn", drawn }, { "triangles", triangles.size() } };
        return sheet;
    }

    const Figure order(
        "bvh.order", "The boxes of the visited nodes, from yellow to red", Part::VisualDebugging, drawOrder);
    const Figure hit("bvh.hit", "The first hit is drawn, the second is not", Part::VisualDebugging, drawHit);

}
}
