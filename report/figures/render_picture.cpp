// The same scene by few and by many rays a pixel.
#include "report/figure.h"
#include "report/pictures.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::render_picture {
namespace {

    constexpr glm::ivec2 size { 340, 255 };

    worker::RenderRequest requestOf(int numSamples, bool isStratified)
    {
        return sceneNamed("multisampling", size,
            { fmt::format("pixel_samples={}", numSamples), fmt::format("jittered_sampling={}", isStratified) });
    }

    // By 12 x 12 stratified rays: their error is about (9 / 144)^0.75, an eighth, of that of 9.
    Picture truthOf(Studio& studio)
    {
        return toPicture(
            "Ground truth: 144 stratified rays, reference", studio.render(Who::Reference, requestOf(144, true)));
    }

    std::string withError(const std::string& label, const Picture& truth, const Picture& picture)
    {
        return fmt::format("{}: RMSE {:.3f}", label, rmse(truth, picture));
    }

    struct Shot {
        Picture picture;
        double error = 0.0;
    };

    Shot shoot(
        Studio& studio, Who who, const Picture& truth, const std::string& label, int numSamples, bool isStratified)
    {
        Picture picture = toPicture(label, studio.render(who, requestOf(numSamples, isStratified)));
        const double error = rmse(truth, picture);
        picture.label = withError(label, truth, picture);
        return { std::move(picture), error };
    }

    Sheet drawPictures(Studio& studio)
    {
        const Picture truth = truthOf(studio);
        const Shot shots[] = { shoot(studio, Who::Submission, truth, "1 ray a pixel", 1, false),
            shoot(studio, Who::Submission, truth, "16 uniform rays", 16, false),
            shoot(studio, Who::Submission, truth, "16 stratified rays", 16, true) };
        Sheet sheet;
        sheet.columns = 3;
        for (const Shot& shot : shots)
            sheet.panels.emplace_back(shot.picture);
        for (const Shot& shot : shots) {
            Picture part = magnified(crop(shot.picture, { 145, 145 }, { 48, 36 }), 8);
            part.label = "magnified 8 times";
            sheet.panels.emplace_back(std::move(part));
        }
        const Picture reference = toPicture("reference", studio.render(Who::Reference, requestOf(16, true)));
        const double one = shots[0].error, uniform = shots[1].error, stratified = shots[2].error;
        sheet.facts = { { "scene", "multisampling.toml" }, { "samples", "1 and 16 a pixel" }, { "seed", "0" },
            { "ground truth", "144 stratified rays a pixel" },
            { "16 stratified rays against the reference's",
                fmt::format("RMSE {:.2g}", rmse(reference, shots[2].picture)) } };
        sheet.claims
            = { { fmt::format("16 uniform rays leave an error of {:.3f} of the {:.3f} of one ray, 16 stratified "
                              "ones {:.3f}: {:.1f} times less than uniform.",
                      uniform, one, stratified, uniform / stratified),
                one > uniform && uniform > stratified } };
        sheet.data = { { "one", one }, { "uniform", uniform }, { "stratified", stratified } };
        return sheet;
    }

    // ---- Eight rays

    Sheet drawDifferences(Studio& studio)
    {
        const Picture truth = truthOf(studio);
        Sheet sheet;
        sheet.columns = 3;
        const auto add = [&](Who who, const std::string& label, int numSamples, bool isStratified) {
            const Shot shot = shoot(studio, who, truth, label, numSamples, isStratified);
            sheet.panels.emplace_back(difference(shot.picture.label, truth, shot.picture, 4.0f));
            return shot.error;
        };
        const double uniform8 = add(Who::Submission, "8 uniform", 8, false);
        const double uniform9 = add(Who::Submission, "9 uniform", 9, false);
        const double stratified = add(Who::Submission, "8 stratified: 3 × 3", 8, true);
        const double reference8 = add(Who::Reference, "8 uniform, reference", 8, false);
        add(Who::Reference, "9 uniform, reference", 9, false);
        const double referenceStratified = add(Who::Reference, "8 stratified: 3 × 3, reference", 8, true);
        sheet.facts = { { "scene", "multisampling.toml" }, { "samples", "8 and 9 a pixel" },
            { "shown", "absolute difference, four times as bright" }, { "ground truth", "144 stratified rays a pixel" },
            { "seed", "0" } };
        sheet.claims
            = { { fmt::format("Stratified sampling takes n × n rays, n = round(√8) = 3: 9 rays where 8 are asked "
                              "for. It is not the one ray more: 9 uniform rays err {:.3f}, 8 uniform {:.3f}, "
                              "3 × 3 stratified {:.3f}.",
                      uniform9, uniform8, stratified),
                stratified < uniform9 && stratified < uniform8 } };
        sheet.data = { { "uniform8", uniform8 }, { "uniform9", uniform9 }, { "stratified", stratified },
            { "reference_uniform8", reference8 }, { "reference_stratified", referenceStratified } };
        return sheet;
    }

    const Figure pictures(
        "multisampling.pictures", "One ray a pixel, 16 uniform and 16 stratified", Part::RenderedImages, drawPictures);
    const Figure differences(
        "multisampling.difference", "Eight rays a pixel, and the ground truth", Part::RenderedImages, drawDifferences);

}
}
