// Figures of what the traversal draws: the boxes in their order, and the triangle that was hit.
#include "report/figure.h"
#include "report/figures/ray_drawing.h"
#include "report/figures/stage.h"
#include "report/pictures.h"
#include "report/studio.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace report {
namespace {

    constexpr glm::ivec2 size { 520, 520 };

    // Into an eye of the monkey, and out of the back of its head.
    constexpr glm::ivec2 pixel { 200, 305 };

    worker::RenderRequest monkeyFromTheSide()
    {
        auto request = sceneNamed("monkey", size);
        request.orbit = { 12, 55 };
        return request;
    }

    std::vector<Fact> factsOfRay()
    {
        return { { "scene", "monkey.toml" }, { "pixel", fmt::format("{}, {}", pixel.x, pixel.y) } };
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

    Drawing drawnBy(Studio& studio, Who who, const worker::DebugRay& ray)
    {
        return toDrawing(studio.nameOf(who), ray, studio.render(who, monkeyFromTheSide()));
    }

    worker::DebugRay boxesAndRay(Studio& studio, Who who)
    {
        return onlyDrawn(studio.followRay(who, monkeyFromTheSide(), pixel), [](const debug::Shape& shape) {
            return shape.cause.way == debug::Way::Path && !std::holds_alternative<debug::DrawnTriangle>(shape.drawn);
        });
    }

    Sheet drawOrder(Studio& studio)
    {
        const worker::DebugRay ray = boxesAndRay(studio, Who::Submission);
        const worker::DebugRay expected = boxesAndRay(studio, Who::Reference);
        const auto boxes = drawnOf<debug::DrawnBox>(ray), theirs = drawnOf<debug::DrawnBox>(expected);

        Sheet sheet { .panels = { drawnBy(studio, Who::Submission, ray), drawnBy(studio, Who::Reference, expected),
                          strip(boxes), strip(theirs) },
            .facts = factsOfRay() };
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

    // The ray, the triangles, and nothing of the tree.
    worker::DebugRay trianglesAndRay(Studio& studio, Who who)
    {
        return onlyDrawn(studio.followRay(who, monkeyFromTheSide(), pixel), [](const debug::Shape& shape) {
            return shape.cause.way == debug::Way::Path
                && (std::holds_alternative<debug::DrawnTriangle>(shape.drawn)
                    || std::holds_alternative<debug::DrawnRay>(shape.drawn));
        });
    }

    Sheet drawHit(Studio& studio)
    {
        const std::vector<Crossing> crossings = Stage(monkeyFromTheSide()).crossings(pixel);
        worker::DebugRay ray = trianglesAndRay(studio, Who::Submission);
        const auto triangles = drawnOf<debug::DrawnTriangle>(ray);
        worker::DebugRay expected = trianglesAndRay(studio, Who::Reference);
        addCrossings(ray, crossings);
        addCrossings(expected, crossings);

        Sheet sheet { .panels = { drawnBy(studio, Who::Submission, ray), drawnBy(studio, Who::Reference, expected) },
            .facts = factsOfRay() };
        std::vector<float> distances;
        std::vector<std::size_t> drawn;
        for (const Crossing& crossing : crossings) {
            distances.push_back(crossing.t);
            if (std::ranges::any_of(triangles, [&](const auto& triangle) { return isOf(triangle, crossing); }))
                drawn.push_back(distances.size());
        }
        sheet.claims
            = { { fmt::format("The ray's way leads through {} triangles, at t = {:.2f}; drawn, in white, is {}: "
                              "number {}. The others' outlines (blue) are the report's.",
                      distances.size(), fmt::join(distances, ", "), triangles.size(), fmt::join(drawn, ", ")),
                triangles.size() == 1 && drawn == std::vector<std::size_t> { 1 } && distances.size() > 1 } };
        sheet.data = { { "t", distances }, { "drawn", drawn }, { "triangles", triangles.size() } };
        return sheet;
    }

    const Figure order("bvh.order", "The boxes of the visited nodes, from yellow to red", drawOrder);
    const Figure hit("bvh.hit", "The first hit is drawn, the second is not", drawHit);

}
}
