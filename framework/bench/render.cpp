#include "bench/render.h"
#include "app/number_pairs.h"
#include "app/renderer.h"
#include "app/run_command.h"
#include "bench/comparison.h"
#include "files/error.h"
#include "submission/paths.h"
#include <fstream>
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    std::vector<std::string> namesOrAll(const std::vector<std::string>& names)
    {
        return !names.empty()
            ? names
            : std::vector<std::string> { "cornell_box", "cornell_box_transparency", "monkey", "teapot", "dragon" };
    }

    // One sample a pixel with all that the features have, but for area lights' samples and textures' filters.
    worker::SpeedRequest requestFor(const std::string& scene, const RenderOptions& options)
    {
        const auto folder = std::filesystem::path(submission::sourceDirectory) / "scenes";
        worker::SpeedRequest request { .numRepetitions = options.numRepetitions };
        request.render.scene = (folder / (scene + ".toml")).string();
        request.render.size = app::parseSize(options.size);
        request.render.settings = { "accel_structure=true", "shading=true", "shadows=true", "reflections=true",
            "transparency=true", "texture_mapping=true", "normal_interp=true", "pixel_samples=1" };
        return request;
    }

    void save(const std::string& path, const std::vector<Comparison>& comparisons)
    {
        const nlohmann::json report { { "rows", toJson(comparisons) } };
        if (!(std::ofstream(path) << report.dump(2) << '\n'))
            throw files::Error(path, "cannot be written");
    }

    void measureScenes(const RenderOptions& options)
    {
        app::Renderer renderer(options.with);
        std::vector<Comparison> all;
        printHeader();
        for (const std::string& scene : namesOrAll(options.scenes)) {
            const auto speed = renderer.ask<worker::Speed>("render.speed", requestFor(scene, options));
            for (const Comparison& comparison : compare(scene, options.with, speed)) {
                print(comparison);
                all.push_back(comparison);
            }
        }
        if (!options.json.empty())
            save(options.json, all);
    }

}

void declareRender(CLI::App& cli, RenderOptions& options)
{
    CLI::App& render = *cli.add_subcommand("render", "Whole frames beside the bare traversal of their rays");
    render.add_option("--scene", options.scenes, "A scene of the folder scenes; repeatable");
    render.add_option("--with", options.with, "Whose code: student, reference, or a submission's folder")
        ->capture_default_str();
    render.add_option("--size", options.size, "Pixels, as WIDTHxHEIGHT")->capture_default_str();
    render.add_option("--repetitions", options.numRepetitions, "Times that everybody has a turn")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    render.add_option("--json", options.json, "Write the figures to this file");
    render.footer(
        "frame: renderImage. Its rays again: hits, by intersectRayWithBVH or BVH::intersect; traversal, by the "
        "library's tree alone. Small pictures and many repetitions are what a busy machine disturbs least.");
}

int measureRender(const RenderOptions& options)
{
    try {
        measureScenes(options);
        return app::Success;
    } catch (const worker::Failure& failure) {
        fmt::print(stderr, "the code of {} failed: {}\n", options.with, failure.what());
        return app::SubmissionFailed;
    }
}

}
