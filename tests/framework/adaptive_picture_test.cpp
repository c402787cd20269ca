#include "adaptive/render.h"
#include "app/render_pixels.h"
#include "files/scene_file.h"
#include "recursive.h"
#include "screen.h"
#include "truth/light.h"
#include "truth/polygon.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace tests;
using adaptive::Picture;
using adaptive::PixelRays;

namespace {

constexpr int side = 24;
const auto nobody = [](float) {};

Picture render(const World& world, const Trackball& camera, glm::ivec2 size, double error, uint32_t seed)
{
    const PixelRays rays(world.scene, world.bvh, world.features, camera, size, seed);
    return adaptive::render(rays, size, { .error = error }, nobody);
}

std::vector<glm::dvec3> colorsOf(const Picture& picture)
{
    std::vector<glm::dvec3> colors;
    for (const adaptive::Estimate& estimate : picture.estimates())
        colors.push_back(estimate.mean());
    return colors;
}

// Over all seeds together: what pictures err, and what they are believed to.
struct Errors {
    double real = 0.0, believed = 0.0;

    void add(const Picture& picture, const std::vector<double>& truths)
    {
        for (std::size_t i = 0; i < truths.size(); ++i) {
            const glm::dvec3 difference = glm::clamp(picture.estimates()[i].mean(), 0.0, 1.0) - truths[i];
            real += glm::dot(difference, difference) / 3.0;
            believed += picture.errors()[i] * picture.errors()[i];
        }
    }
    [[nodiscard]] double ratio() const { return std::sqrt(real / believed); }
};

// Of pictures.
struct Means {
    double sum = 0.0, sumOfSquares = 0.0;

    template <typename Color> void add(const std::vector<Color>& colors)
    {
        double mean = 0.0;
        for (const Color& color : colors)
            mean += static_cast<double>(color.y) / static_cast<double>(colors.size());
        sum += mean;
        sumOfSquares += mean * mean;
    }
    [[nodiscard]] double varianceOfMean(double n) const { return (sumOfSquares - sum * sum / n) / (n - 1.0) / n; }
};

// White triangles on black, given in pixels of a picture; what a pixel shows is how much of it they cover.
struct Triangles {
    static inline const std::vector<truth::Polygon> corners { { { 1.3, 1.2 }, { 21.1, 5.3 }, { 4.2, 11.7 } },
        { { 12.4, 9.1 }, { 23.9, 8.7 }, { 17.2, 22.8 } }, { { 2.1, 13.0 }, { 9.9, 20.3 }, { 3.3, 22.9 } } };

    static std::vector<double> truths()
    {
        std::vector<double> truths;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                truths.push_back(0.0);
                for (const truth::Polygon& triangle : corners) // they do not overlap
                    truths.back()
                        += truth::areaOf(truth::clipToRectangle(triangle, glm::dvec2(x, y), glm::dvec2(x + 1, y + 1)));
            }
        return truths;
    }

    static Scene scene(const Trackball& camera)
    {
        Scene scene;
        for (const truth::Polygon& triangle : corners) {
            Mesh& mesh = scene.meshes.emplace_back();
            mesh.triangles.emplace_back(0, 1, 2);
            mesh.material.kd = glm::vec3(1.0f);
            for (const glm::dvec2& corner : triangle) { // on a plane across the view
                const Ray ray = camera.generateRay(glm::vec2(corner) / static_cast<float>(side) * 2.0f - 1.0f);
                mesh.vertices.push_back(
                    { ray.origin + 4.0f / glm::dot(ray.direction, camera.forward()) * ray.direction, {}, {} });
            }
        }
        scene.lights.emplace_back(PointLight { camera.position(), glm::vec3(1.0f) });
        return scene;
    }

    Trackball camera { 0.87f, 4.0f };
    World world { scene(camera), { .enableAccelStructure = true } };
};

files::SceneFile cornellBox()
{
    files::SceneFile file = files::loadSceneFile(RAYWORK_SCENES "/cornell_box_parallelogram_light.toml");
    file.config.size = { 20, 20 };
    return file;
}

}

TEST_CASE("The believed error of a picture of edges is honest, and each pixel's below what was asked for", "[adaptive]")
{
    const Triangles triangles;
    const std::vector<double> truths = Triangles::truths();
    for (const double error : { 0.05, 0.02, 0.005 }) {
        Errors errors;
        for (uint32_t seed = 0; seed < 12; ++seed) {
            const Picture picture = render(triangles.world, triangles.camera, glm::ivec2(side), error, seed);
            errors.add(picture, truths);
            CHECK(adaptive::summarize(picture).largestError <= error);
        }
        CAPTURE(error, errors.ratio());
        CHECK(errors.ratio() <= 1.1); // what is promised
        CHECK(errors.ratio() >= 0.4); // believing too much costs samples
    }
}

TEST_CASE("The believed error of a light behind a blocker is honest", "[adaptive]")
{
    const glm::vec3 white(1.0f);
    const ParallelogramLight light { { -0.5f, 2.0f, -0.5f }, { 1.0f, 0.0f, 0.3f }, { 0.0f, 0.0f, 1.0f }, white, white,
        white, 0.5f * white };
    Scene scene;
    addParallelogram(scene, { .kd = white }, { -9, 0, -9 }, { 0, 0, 18 }, { 18, 0, 0 });
    addParallelogram(scene, {}, { 0.05f, 1, -9 }, { 0.7f, 0, 18 }, { 9, 0, 0 });
    scene.lights.emplace_back(light);
    std::vector<glm::dvec3> blocker;
    for (const Vertex& vertex : scene.meshes[1].vertices)
        blocker.emplace_back(vertex.position);
    const World world(std::move(scene), { .enableShading = true, .enableShadows = true, .enableAccelStructure = true });
    Trackball camera(1e-4f); // sees a point of the floor, from the side where no blocker is
    camera.setCamera(glm::vec3(0.0f), { 0.5f, 1.57f, 0.0f }, 3.0f);
    const truth::Receiver floor { glm::dvec3(0.0), { 0.0, 1.0, 0.0 }, glm::dvec3(1.0) };
    const double truth = truth::contribution(light, floor, blocker).x;
    REQUIRE(truth > 0.2); // it is seen in part

    Errors errors;
    for (uint32_t seed = 0; seed < 12; ++seed)
        errors.add(render(world, camera, { 16, 16 }, 0.01, seed), std::vector<double>(256, truth));
    CAPTURE(errors.ratio());
    CHECK(errors.ratio() <= 1.1);
}

TEST_CASE("Samples are where edges are: far from them a pixel has the fewest", "[adaptive]")
{
    const Triangles triangles;
    const Picture picture = render(triangles.world, triangles.camera, glm::ivec2(side), 0.005, 0);
    const std::vector<double> truths = Triangles::truths();
    const auto isFlat = [&](int x, int y) {
        const double truth = truths[static_cast<std::size_t>(y * side + x)];
        return truth == 0.0 || truth > 1.0 - 1e-9;
    };
    for (int y = 1; y < side - 1; ++y) {
        for (int x = 1; x < side - 1; ++x) {
            bool areAllFlat = true;
            for (int i = 0; i < 9; ++i)
                areAllFlat &= isFlat(x - 1 + i % 3, y - 1 + i / 3);
            const uint32_t numRays = picture.estimates()[static_cast<std::size_t>(y * side + x)].numRays;
            if (areAllFlat)
                CHECK(numRays == Picture::fewestRays);
        }
    }
    CHECK(adaptive::summarize(picture).mostSamples > 8 * Picture::fewestRays);
}

TEST_CASE("A picture to an error is the same bit for bit for any number of threads", "[adaptive]")
{
    const files::SceneFile file = cornellBox();
    const World world(file.scene, file.config.features);
    const auto colorsWith = [&](std::size_t numThreads, uint32_t seed) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, numThreads);
        return colorsOf(render(world, makeTrackball(file.config), file.config.size, 0.02, seed));
    };
    const auto colors = colorsWith(1, 0);
    CHECK(colors == colorsWith(4, 0));
    CHECK(colors == colorsWith(4, 0));
    CHECK(colors != colorsWith(1, 1));
}

TEST_CASE("A picture to an error has the same expectation as one of a fixed number of samples", "[adaptive]")
{
    constexpr uint32_t numSeeds = 24;
    files::SceneFile file = cornellBox();
    file.config.features.numPixelSamples = 16;
    const World world(file.scene, file.config.features);
    const Trackball camera = makeTrackball(file.config);
    Means toError, fixed;
    for (uint32_t seed = 0; seed < numSeeds; ++seed) {
        toError.add(colorsOf(render(world, camera, file.config.size, 0.05, seed)));
        Screen screen(file.config.size);
        app::renderPixels(world.scene, world.bvh, world.features, camera, screen, seed);
        fixed.add(screen.pixels());
    }
    const double deviation = std::sqrt(toError.varianceOfMean(numSeeds) + fixed.varianceOfMean(numSeeds));
    // Less than once in 10,000 by chance; the seeds are fixed.
    CHECK(std::abs(toError.sum - fixed.sum) / numSeeds < 5.0 * deviation);
}

TEST_CASE("The mean of 2^20 samples of a pixel does not drift", "[adaptive]")
{
    constexpr uint32_t numRays = 1u << 20;
    const Triangles triangles;
    const auto& [camera, world] = triangles;
    const PixelRays rays(world.scene, world.bvh, world.features, camera, glm::ivec2(side), 3);
    const std::vector<double> truths = Triangles::truths();
    const auto isHalf = [](double truth) { return truth > 0.4 && truth < 0.6; };
    const auto onEdge = static_cast<std::size_t>(std::ranges::find_if(truths, isHalf) - truths.begin());
    REQUIRE(onEdge < truths.size());
    // Of this many even samples an edge leaves an error of about numRays^-0.75 = 3e-5.
    CHECK(rays.mean(onEdge, 0, numRays).x == Approx(truths[onEdge]).margin(1e-4));
}

TEST_CASE("renderRays does not drift over 2^20 rays", "[adaptive]")
{
    Scene scene;
    addPane(scene, { .kd = glm::vec3(0.1f) }, 0.0f);
    scene.lights.emplace_back(PointLight { { 0, 0, 1 }, glm::vec3(1.0f) });
    World world(std::move(scene), { .enableAccelStructure = true });
    const std::vector<Ray> rays(1u << 20, Ray { { 0, 0, 1 }, { 0, 0, -1 } });
    CHECK(renderRays(world.state, rays) == glm::vec3(0.1f)); // exactly: all are the same
}

TEST_CASE("A limit of time ends a render, with every pixel's fewest samples", "[adaptive]")
{
    const files::SceneFile file = cornellBox();
    const World world(file.scene, file.config.features);
    const Trackball camera = makeTrackball(file.config);
    const PixelRays rays(world.scene, world.bvh, world.features, camera, file.config.size, 0);
    const auto hurried = summarize(adaptive::render(rays, file.config.size, { .seconds = 1e-9 }, nobody));
    CHECK(hurried.mostSamples == Picture::fewestRays);
    // Whatever the machine does meanwhile: an error that is reached ends it long before an hour.
    const auto reached
        = summarize(adaptive::render(rays, file.config.size, { .error = 0.02, .seconds = 3600.0 }, nobody));
    CHECK(reached.largestError <= 0.02);
    CHECK(reached.numSamples > hurried.numSamples);
}
