#include "grading/picture.h"
#include "grading/expect.h"
#include "submission/paths.h"
#include <cmath>
#include <fmt/format.h>

namespace grading {
namespace {

    constexpr int tileSize = 8; // pixels

    using Picture = worker::Rendering;

    // Calls f(corner, area) for each tile of the picture.
    template <typename F> void forEachTile(glm::ivec2 size, const F& f)
    {
        for (int y = 0; y < size.y; y += tileSize)
            for (int x = 0; x < size.x; x += tileSize)
                f(glm::ivec2(x, y), glm::min(glm::ivec2(tileSize), size - glm::ivec2(x, y)));
    }

    // The sum of f(pixel index) over a tile, divided by its pixels.
    template <typename F> glm::dvec3 tileMean(glm::ivec2 size, glm::ivec2 corner, glm::ivec2 area, const F& f)
    {
        glm::dvec3 sum { 0.0 };
        for (int y = corner.y; y < corner.y + area.y; ++y)
            for (int x = corner.x; x < corner.x + area.x; ++x)
                sum += f(static_cast<std::size_t>(y * size.x + x));
        return sum / static_cast<double>(area.x * area.y);
    }

    std::string describe(const worker::RenderRequest& request)
    {
        return std::filesystem::path(request.scene).filename().string();
    }

    void expectShape(const worker::RenderRequest& request, const Picture& came)
    {
        const auto numPixels = static_cast<std::size_t>(request.size.x) * static_cast<std::size_t>(request.size.y);
        expect(came.size == request.size, describe(request), "a picture of another size", "the size asked for");
        expectCount(describe(request), came.pixels.size(), numPixels);
        for (const glm::vec3& color : came.pixels)
            expect(std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z), describe(request),
                "a pixel of " + toText(color), "finite colours");
    }

    std::string whereIs(glm::ivec2 corner)
    {
        return fmt::format(
            "around pixel ({}, {}) from the bottom left", corner.x + tileSize / 2, corner.y + tileSize / 2);
    }

    // Mean and variance of a tile's mean over several pictures.
    struct Estimate {
        glm::dvec3 mean { 0.0 };
        glm::dvec3 variance { 0.0 }; // of the mean
    };

    Estimate estimate(const std::vector<Picture>& pictures, glm::ivec2 corner, glm::ivec2 area)
    {
        std::vector<glm::dvec3> means;
        for (const Picture& picture : pictures)
            means.push_back(
                tileMean(picture.size, corner, area, [&](std::size_t i) { return glm::dvec3(picture.pixels[i]); }));
        const auto n = static_cast<double>(means.size());
        Estimate result;
        for (const glm::dvec3& mean : means)
            result.mean += mean / n;
        for (const glm::dvec3& mean : means)
            result.variance += (mean - result.mean) * (mean - result.mean) / (n * (n - 1.0));
        return result;
    }

}

worker::RenderRequest pictureOf(const std::string& scene, std::vector<std::string> settings)
{
    worker::RenderRequest request;
    request.scene = fmt::format("{}/scenes/{}.toml", submission::sourceDirectory, scene);
    request.settings = std::move(settings);
    request.settings.insert(request.settings.begin(), { "pixel_samples=16", "jittered_sampling=true" });
    request.size = { 96, 96 };
    request.numThreads = 1;
    return request;
}

void expectSamePicture(const worker::RenderRequest& request, const Picture& came, const Picture& expected)
{
    // A tile has 64 pixels: one that is black instead of white makes 0.016. Rays that start up to 1e-3 beside each
    // other change a hundredth of the samples along an edge.
    constexpr double tolerance = 0.01;
    expectShape(request, came);
    forEachTile(expected.size, [&](glm::ivec2 corner, glm::ivec2 area) {
        const glm::dvec3 difference = tileMean(expected.size, corner, area,
            [&](std::size_t i) { return glm::abs(glm::dvec3(came.pixels[i]) - glm::dvec3(expected.pixels[i])); });
        const double worst = std::max({ difference.x, difference.y, difference.z });
        expect(worst <= tolerance, describe(request),
            fmt::format("a mean difference of {:.3f} {}", worst, whereIs(corner)),
            fmt::format("{} or less", tolerance));
    });
}

void comparePictures(Exam& exam, const worker::RenderRequest& request)
{
    const auto came = exam.ask<Picture>("render.pixels", request);
    const auto expected = exam.askReference<Picture>("render.pixels", request);
    exam.pictures = std::make_shared<PicturePair>(PicturePair { came.size, came.pixels, expected.pixels });
    expectSamePicture(request, came, expected);
}

void compareNoisyPictures(Exam& exam, const worker::RenderRequest& request)
{
    constexpr int numPictures = 12;
    // Student's t with 11 degrees of freedom or more exceeds 9 with probability 2e-6: over 432 tiles and channels a
    // right solution fails once in a thousand, and then only if the difference could be seen as well.
    constexpr double significant = 9.0;
    constexpr double visible = 0.01;

    std::vector<Picture> came, expected;
    worker::RenderRequest seeded = request;
    for (int i = 0; i < numPictures; ++i) {
        seeded.seed = exam.random.seed();
        came.push_back(exam.ask<Picture>("render.pixels", seeded));
        expectShape(request, came.back());
        seeded.seed = exam.random.seed();
        expected.push_back(exam.askReference<Picture>("render.pixels", seeded));
    }
    forEachTile(request.size, [&](glm::ivec2 corner, glm::ivec2 area) {
        const Estimate ours = estimate(expected, corner, area);
        const Estimate theirs = estimate(came, corner, area);
        for (int c = 0; c < 3; ++c) {
            const double difference = std::abs(theirs.mean[c] - ours.mean[c]);
            const double deviation = std::sqrt(theirs.variance[c] + ours.variance[c]);
            expect(difference <= visible || difference <= significant * deviation, describe(request),
                fmt::format("a mean of {:.3f} {}", theirs.mean[c], whereIs(corner)),
                fmt::format("{:.3f}, give or take {:.3f}", ours.mean[c], significant * deviation));
        }
    });
}

}
