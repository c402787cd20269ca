// Rays in the middles of their cells against rays anywhere in them, on two patterns whose truth is known.
#include "report/figure.h"
#include "report/pictures.h"
#include "report/probes/pixel_question.h"
#include "report/studio.h"
#include "truth/polygon.h"
#include <boost/math/quadrature/gauss.hpp>
#include <fmt/format.h>

namespace report::render_aliasing {
namespace {

    constexpr int perSide = 4; // cells along a side of a pixel
    constexpr uint32_t numPictures = 8; // of different seeds

    PixelSamples jittered(Studio& studio, Who who, glm::ivec2 size, uint32_t seed)
    {
        return studio.ask<PixelSamples>(
            who, "figures.pixel_samples", PixelQuestion { size, perSide * perSide, true, seed });
    }

    // The same cells, without chance.
    PixelSamples unjittered(glm::ivec2 size)
    {
        PixelSamples samples;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                std::vector<glm::vec2>& inPixel = samples.emplace_back();
                for (int i = 0; i < perSide * perSide; ++i)
                    inPixel.push_back(
                        glm::vec2(x, y) + (glm::vec2(i % perSide, i / perSide) + 0.5f) / static_cast<float>(perSide));
            }
        return samples;
    }

    // What the samples make of a pattern: glm::dvec2 -> double.
    template <typename Pattern>
    Picture average(std::string label, glm::ivec2 size, const PixelSamples& samples, const Pattern& pattern)
    {
        Picture picture { std::move(label), size, {} };
        for (const std::vector<glm::vec2>& inPixel : samples) {
            double sum = 0.0;
            for (const glm::vec2& place : inPixel)
                sum += pattern(glm::dvec2(place));
            picture.pixels.emplace_back(static_cast<float>(sum / std::max(1.0, static_cast<double>(inPixel.size()))));
        }
        return picture;
    }

    Picture meanOf(std::string label, const std::vector<Picture>& pictures)
    {
        Picture mean { std::move(label), pictures.front().size,
            std::vector<glm::vec3>(pictures.front().pixels.size()) };
        for (const Picture& picture : pictures)
            for (std::size_t i = 0; i < mean.pixels.size(); ++i)
                mean.pixels[i] += picture.pixels[i] / static_cast<float>(pictures.size());
        return mean;
    }

    // What both ways of sampling make of a pattern.
    struct Comparison {
        Picture truth, regular, jittered, mean, reference;
        double regularError, jitteredError, meanError;
    };

    template <typename Pattern>
    Comparison compare(Studio& studio, glm::ivec2 size, const Pattern& pattern, Picture truth)
    {
        const Picture regular = average("Unjittered", size, unjittered(size), pattern);
        std::vector<Picture> pictures;
        for (uint32_t seed = 1; seed <= numPictures; ++seed)
            pictures.push_back(average("Jittered, " + studio.nameOf(Who::Submission), size,
                jittered(studio, Who::Submission, size, seed), pattern));
        const Picture mean = meanOf("mean", pictures);
        const Picture reference
            = average("Jittered, reference", size, jittered(studio, Who::Reference, size, 1), pattern);
        return { truth, regular, pictures.front(), mean, reference, rmse(truth, regular), rmse(truth, pictures.front()),
            rmse(truth, mean) };
    }

    // Pictures of half of the noise's variance have 1 / sqrt(2) of its error; what all have in common stays.
    Claim noiseClaim(const Comparison& c)
    {
        return { fmt::format(
                     "What jittered rays err is noise, which seeds do not share: the mean of {} pictures errs {:.4f}, "
                     "one {:.4f}; of noise alone √{} times less, {:.4f}. What unjittered rays err, {:.4f}, would be "
                     "the same each time.",
                     numPictures, c.meanError, c.jitteredError, numPictures, c.jitteredError / std::sqrt(numPictures),
                     c.regularError),
            c.meanError < 1.15 * c.jitteredError / std::sqrt(numPictures) }; // and a little chance
    }

    std::vector<Fact> factsOf(const std::string& pattern, const Comparison& c)
    {
        return { { "pattern", pattern }, { "samples", "16 a pixel, in 4 × 4 cells" }, { "seed", "1" },
            { "RMSE",
                fmt::format("unjittered {:.4f}, jittered {:.4f}, the reference's {:.4f}", c.regularError,
                    c.jitteredError, rmse(c.truth, c.reference)) } };
    }

    nlohmann::json dataOf(const Comparison& c)
    {
        return { { "regular", c.regularError }, { "jittered", c.jitteredError }, { "mean", c.meanError } };
    }

    // ---- Rings around the corner, whose frequency grows with their radius

    constexpr glm::ivec2 plateSize { 180, 180 };
    constexpr double phantom = 140.0; // pixels from the corner where a pixel has as many rings as cells
    constexpr double chirp = glm::pi<double>() * perSide / phantom; // frequency: chirp * radius / pi

    double zonePlate(const glm::dvec2& p)
    {
        return 0.5 + 0.5 * std::cos(chirp * glm::dot(p, p));
    }

    // Its exact mean over each pixel: cos(x^2 + y^2) is the real part of exp(i x^2) exp(i y^2), of which each is
    // integrated on its own. A pixel has five periods at most, to which 30 points are enough.
    Picture zonePlateTruth()
    {
        using Rule = boost::math::quadrature::gauss<double, 30>;
        std::vector<glm::dvec2> means; // of exp(i chirp x^2) over [x, x + 1]
        for (int x = 0; x < plateSize.x; ++x)
            means.emplace_back(Rule::integrate([](double p) { return std::cos(chirp * p * p); }, x, x + 1.0),
                Rule::integrate([](double p) { return std::sin(chirp * p * p); }, x, x + 1.0));
        Picture truth { "Truth", plateSize, {} };
        for (const glm::dvec2& b : means)
            for (const glm::dvec2& a : means)
                truth.pixels.emplace_back(static_cast<float>(0.5 + 0.5 * (a.x * b.x - a.y * b.y)));
        return truth;
    }

    // How far the pixels around the phantom of the corner are from grey together with their neighbours: where rings
    // are that are not there.
    double errorAt(const Picture& truth, const Picture& picture, glm::ivec2 place)
    {
        constexpr glm::ivec2 part { 12, 12 };
        return rmse(crop(truth, place - part / 2, part), crop(picture, place - part / 2, part));
    }

    Sheet drawZonePlate(Studio& studio)
    {
        const Comparison c = compare(studio, plateSize, zonePlate, zonePlateTruth());
        const glm::ivec2 place(static_cast<int>(phantom));
        const double regular = errorAt(c.truth, c.regular, place), random = errorAt(c.truth, c.jittered, place);
        Sheet sheet;
        sheet.columns = 3;
        for (const Picture* picture : { &c.truth, &c.regular, &c.jittered })
            sheet.panels.emplace_back(magnified(*picture, 2));
        sheet.facts = factsOf("rings around the bottom left, ever finer: at 140 pixels four to a pixel", c);
        sheet.claims
            = { { fmt::format("Where four rings pass through a pixel along both axes, unjittered rays see rings "
                              "that are not there: an error of {:.2f}, where jittered rays have noise of {:.2f}.",
                      regular, random),
                    regular > 2.0 * random },
                  noiseClaim(c) };
        sheet.data = dataOf(c);
        sheet.data["phantom"] = { regular, random };
        return sheet;
    }

    // ---- An edge that rises one pixel in forty

    constexpr glm::ivec2 edgeSize { 85, 8 };

    double heightOverEdge(const glm::dvec2& p)
    {
        return p.y - 3.1 - p.x / 40.0;
    }

    double edge(const glm::dvec2& p)
    {
        return heightOverEdge(p) >= 0.0 ? 1.0 : 0.0;
    }

    Picture edgeTruth()
    {
        Picture truth { "Truth", edgeSize, {} };
        for (int y = 0; y < edgeSize.y; ++y)
            for (int x = 0; x < edgeSize.x; ++x) {
                const truth::Polygon pixel { { x, y }, { x + 1, y }, { x + 1, y + 1 }, { x, y + 1 } };
                truth.pixels.emplace_back(static_cast<float>(truth::areaOf(truth::clip(pixel, heightOverEdge))));
            }
        return truth;
    }

    // Of the pixels that the edge crosses.
    std::size_t numGreys(const Picture& picture)
    {
        std::vector<float> greys;
        for (const glm::vec3& pixel : picture.pixels)
            if (pixel.x > 0.0f && pixel.x < 1.0f)
                greys.push_back(pixel.x);
        std::ranges::sort(greys);
        greys.erase(std::ranges::unique(greys).begin(), greys.end());
        return greys.size();
    }

    Sheet drawEdge(Studio& studio)
    {
        const Comparison c = compare(studio, edgeSize, edge, edgeTruth());
        const std::size_t regular = numGreys(c.regular), random = numGreys(c.jittered);
        Sheet sheet;
        sheet.columns = 1;
        for (const Picture* picture : { &c.truth, &c.regular, &c.jittered })
            sheet.panels.emplace_back(magnified(*picture, 12));
        sheet.facts = factsOf("white above an edge that rises one pixel in forty", c);
        sheet.claims
            = { { fmt::format("Four rows of rays give unjittered pixels {} greys, in steps of ten pixels; jittered "
                              "ones have {}. The errors are {:.3f} and {:.3f}.",
                      regular, random, c.regularError, c.jitteredError),
                    regular < random && c.jitteredError < c.regularError },
                  noiseClaim(c) };
        sheet.data = dataOf(c);
        sheet.data["greys"] = { regular, random };
        return sheet;
    }

    const Figure plate("multisampling.zone_plate", "Jittered and unjittered rays on a zone plate", Part::RenderedImages,
        drawZonePlate);
    const Figure slanted(
        "multisampling.edge", "Jittered and unjittered rays on an edge along the rows", Part::RenderedImages, drawEdge);

}
}
