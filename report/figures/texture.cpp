// Figures of filtering: nearest against bilinear, magnified.
#include "report/figure.h"
#include "report/figures/stage.h"
#include "report/pictures.h"
#include "report/studio.h"
#include <algorithm>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/gtx/component_wise.hpp>

namespace report::texture {
namespace {

    worker::RenderRequest filtered(const std::string& scene, glm::ivec2 size, const std::string& bilinear)
    {
        return sceneNamed(scene, size, { "bilinear_filtering=" + bilinear });
    }

    // The largest difference of a channel between pixels side by side or one above the other that show the texture.
    double largestStep(const Stage& stage, const Picture& picture)
    {
        const auto hits = stage.hits();
        const auto width = static_cast<std::size_t>(picture.size.x);
        double largest = 0.0;
        const auto compare = [&](std::size_t a, std::size_t b) {
            if (hits[a] && hits[b] && hits[a]->material.kdTexture && hits[b]->material.kdTexture)
                largest = std::max<double>(largest, glm::compMax(glm::abs(picture.pixels[a] - picture.pixels[b])));
        };
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (i % width > 0)
                compare(i - 1, i);
            if (i >= width)
                compare(i - width, i);
        }
        return largest;
    }

    // A corner of the cube's F, each pixel as a square.
    Slider cornerOfCube(Studio& studio)
    {
        const auto corner = [&](const std::string& label, const std::string& bilinear) {
            const Picture whole
                = toPicture(label, studio.render(Who::Submission, filtered("cube_textured", { 1040, 1040 }, bilinear)));
            return magnified(crop(whole, { 300, 470 }, { 130, 98 }), 4);
        };
        return { corner("nearest, a part of the cube", "false"), corner("bilinear, a part of the cube", "true") };
    }

    Sheet drawBilinear(Studio& studio)
    {
        const glm::ivec2 size { 520, 348 };
        const auto request = filtered("texture_nearest", size, "true");
        const Picture nearest
            = toPicture("nearest", studio.render(Who::Submission, filtered("texture_nearest", size, "false")));
        const worker::Rendering rendering = studio.render(Who::Submission, request);
        const Picture bilinear = toPicture(studio.nameOf(Who::Submission) + ", bilinear", rendering);
        const Picture reference = toPicture("reference, bilinear", studio.render(Who::Reference, request));
        const Stage stage { request };
        const double nearestStep = largestStep(stage, nearest), bilinearStep = largestStep(stage, bilinear);

        Sheet sheet { .panels = { Slider { nearest, bilinear }, reference, cornerOfCube(studio) },
            .facts = factsOf(request, rendering) };
        sheet.facts.push_back(errorAgainst(reference, bilinear));
        sheet.facts.push_back({ "the cube", "cube_textured.toml, 1040 × 1040" });
        sheet.claims
            = { { fmt::format("The largest step between neighbouring pixels of the texture is {:.3f} with nearest "
                              "and {:.3f} with bilinear filtering.",
                      nearestStep, bilinearStep),
                bilinearStep > 0.0 && bilinearStep < 0.2 * nearestStep } }; // a texel is 38 pixels wide
        sheet.data = { { "nearest", nearestStep }, { "bilinear", bilinearStep } };
        return sheet;
    }

    const Figure bilinear(
        "texture.bilinear", "Nearest against bilinear filtering, magnified", Part::RenderedImages, drawBilinear);

}
}
