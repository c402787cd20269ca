#include "grading/stress/probes/cameras.h"
#include "grading/stress/rounding.h"
#include "grading/stress/stress.h"
#include <array>

// Where rays of a pixel meet the screen, by the projection inverted: the camera looks along z, not turned.
namespace stress::camera_pixels {
namespace {

    std::string describe(const PixelRays& query)
    {
        return fmt::format("{}: {} samples of the pixel ({}, {}) of {} x {}, field of view {} degrees, seed {}",
            query.isStratified ? "generatePixelRaysStratified" : "generatePixelRaysUniform", query.numSamples,
            query.pixel.x, query.pixel.y, query.size.x, query.size.y, exactly(query.fieldOfView), query.seed);
    }

    // In pixels, from the pixel's corner.
    glm::dvec2 placeOf(const PixelRays& query, const Ray& ray)
    {
        const glm::dvec3 direction(ray.direction);
        const glm::dvec2 size(query.size);
        const double height = std::tan(glm::radians(static_cast<double>(query.fieldOfView)) / 2.0);
        const glm::dvec2 ndc { -direction.x / direction.z / (height * size.x / size.y),
            direction.y / direction.z / height };
        return (ndc + 1.0) * 0.5 * size - glm::dvec2(query.pixel);
    }

    // In pixels: a place is rounded when the pixel is added, when it is made a fraction of the screen, and when that is
    // moved to -1 .. 1. So the largest of samples may come to lie on the pixel's far edge. The field of view in radians
    // is rounded, of which the tangent makes more the wider it is.
    glm::dvec2 roundedPlace(const PixelRays& query)
    {
        const double half = glm::radians(static_cast<double>(query.fieldOfView)) / 2.0;
        const double ofTangent = 2.0 * half / (std::sin(half) * std::cos(half));
        return glm::dvec2(query.size) * ulpOfOne * (8.0 + ofTangent);
    }

    bool isWithin(const glm::dvec2& place, const glm::dvec2& lower, const glm::dvec2& upper)
    {
        return glm::all(glm::greaterThanEqual(place, lower)) && glm::all(glm::lessThanEqual(place, upper));
    }

    // Each cell of an n x n grid has a ray in it, or beside it by a rounding.
    Judgement judgeCells(const std::vector<glm::dvec2>& places, int n, const glm::dvec2& rounded)
    {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const glm::dvec2 lower = glm::dvec2(x, y) / static_cast<double>(n) - rounded;
                const glm::dvec2 upper = glm::dvec2(x + 1, y + 1) / static_cast<double>(n) + rounded;
                if (std::none_of(places.begin(), places.end(), [&](auto& p) { return isWithin(p, lower, upper); }))
                    return wrong(fmt::format("no ray in the cell ({}, {}) of {} x {}", x, y, n, n), "one in each");
            }
        }
        return right();
    }

    // Rays are not all in the first n-th of their cells, along either axis: of 16 in 4 x 4 cells chance leaves the rest
    // empty once in 4e9 pixels.
    Judgement judgeSpread(const std::vector<glm::dvec2>& places, int n, const glm::dvec2& rounded)
    {
        glm::dvec2 largest { 0.0 };
        for (const glm::dvec2& place : places)
            largest = glm::max(largest, glm::fract(place * static_cast<double>(n)));
        if (glm::all(glm::greaterThanEqual(largest + rounded * static_cast<double>(n), glm::dvec2(1.0 / n))))
            return right();
        return wrong(fmt::format("no ray further into its cell than {}", exactly(largest)), "anywhere in its cell");
    }

    Judgement judge(const PixelRays& query, const RaysOfPixel& came)
    {
        const int n = static_cast<int>(std::round(std::sqrt(query.numSamples)));
        const uint32_t count = query.isStratified ? static_cast<uint32_t>(n * n) : query.numSamples;
        if (came.count != count)
            return wrong(fmt::format("{} rays", came.count), fmt::format("{}", count));
        const glm::dvec2 rounded = roundedPlace(query);
        std::vector<glm::dvec2> places;
        for (uint32_t i = 0; i < std::min<uint32_t>(count, PixelRays::most); ++i) {
            const Ray& ray = came.rays[i];
            places.push_back(placeOf(query, ray));
            const bool isUnit = std::abs(glm::length(glm::dvec3(ray.direction)) - 1.0) <= 8.0 * ulpOfOne;
            if (!(ray.direction.z > 0.0f && isUnit && isWithin(places.back(), -rounded, 1.0 + rounded)))
                return wrong(fmt::format("direction {}, {} from the pixel's corner", exactly(ray.direction),
                                 exactly(places.back())),
                    "a unit vector through the pixel");
        }
        if (!query.isStratified || count != places.size())
            return right();
        const Judgement judgement = judgeCells(places, n, rounded);
        return judgement.isRight && n == 4 ? judgeSpread(places, n, rounded) : judgement;
    }

    const Question<PixelRays, RaysOfPixel> pixelRays { "stress.pixel_rays", describe, judge };

    PixelRays anyPixel(Random& random, bool isStratified)
    {
        const std::array<int, 7> lengths { 1, 2, 3, 100, 801, 10000, 16384 };
        const auto length = [&] { return lengths[static_cast<std::size_t>(random.integer(0, 6))]; };
        PixelRays query {};
        query.size = { length(), 0 };
        query.size.y = length();
        const auto place = [&](int size) { // one of the last as often as elsewhere
            return random.integer(0, 1) == 0 ? size - 1 : random.integer(0, size - 1);
        };
        query.pixel = { place(query.size.x), 0 };
        query.pixel.y = place(query.size.y);
        query.fieldOfView = random.integer(0, 3) == 0 ? magnitude(random, 1e-3f, 1.0f) : random.uniform(1.0f, 175.0f);
        query.seed = random.seed();
        query.numSamples = static_cast<uint32_t>(random.integer(1, 16));
        query.isStratified = isStratified;
        return query;
    }

    const Stress uniform("camera.pixels.uniform", pixelRays,
        randomly<PixelRays>(150'000, [](Random& random) { return anyPixel(random, false); }));
    const Stress stratified("camera.pixels.stratified", pixelRays,
        randomly<PixelRays>(150'000, [](Random& random) { return anyPixel(random, true); }));

    PixelRays of(glm::ivec2 size, glm::ivec2 pixel, uint32_t numSamples, bool isStratified, float fieldOfView = 50.0f)
    {
        return { fieldOfView, size, pixel, 1, numSamples, isStratified };
    }

    const Stress special("camera.pixels.special", pixelRays,
        constructed<PixelRays>({
            { "the only pixel, uniform", of({ 1, 1 }, { 0, 0 }, 16, false) },
            { "the only pixel, stratified", of({ 1, 1 }, { 0, 0 }, 16, true) },
            { "the only pixel, one sample, uniform", of({ 1, 1 }, { 0, 0 }, 1, false) },
            { "the only pixel, one sample, stratified", of({ 1, 1 }, { 0, 0 }, 1, true) },
            { "two samples, stratified: one cell", of({ 8, 6 }, { 7, 5 }, 2, true) },
            { "three samples, stratified: four cells", of({ 8, 6 }, { 7, 5 }, 3, true) },
            { "six samples, stratified: four cells", of({ 8, 6 }, { 0, 5 }, 6, true) },
            { "seven samples, stratified: nine cells", of({ 8, 6 }, { 0, 5 }, 7, true) },
            { "the last pixel of 10,000 to 1, uniform", of({ 10000, 1 }, { 9999, 0 }, 16, false) },
            { "the last pixel of 10,000 to 1, stratified", of({ 10000, 1 }, { 9999, 0 }, 16, true) },
            { "the last pixel of 1 to 10,000, uniform", of({ 1, 10000 }, { 0, 9999 }, 16, false) },
            { "the last pixel of 1 to 10,000, stratified", of({ 1, 10000 }, { 0, 9999 }, 16, true) },
            { "the first pixel of 10,000 to 1", of({ 10000, 1 }, { 0, 0 }, 16, true) },
            { "the last pixel of a wide view", of({ 801, 799 }, { 800, 798 }, 16, true, 175.0f) },
            { "the last pixel of a narrow view", of({ 801, 799 }, { 800, 798 }, 16, true, 1e-3f) },
            { "10,000 samples, stratified", of({ 8, 6 }, { 3, 2 }, 10000, true) },
            { "9,999 samples, stratified", of({ 8, 6 }, { 3, 2 }, 9999, true) },
            { "1,000 samples, uniform", of({ 8, 6 }, { 3, 2 }, 1000, false) },
        }));

}
}
