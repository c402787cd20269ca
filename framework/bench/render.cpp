#include "bench/render.h"
#include "app/number_pairs.h"
#include "app/renderer.h"
#include "app/run_command.h"
#include "bench/frame_comparison.h"
#include "files/text.h"
#include "submission/paths.h"
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    struct Options {
        std::vector<std::string> scenes; // of the folder scenes; empty: a few
        std::string with = "reference";
        std::string size = "512x512";
        std::string json;
        uint32_t numRepetitions = 5;
    };

    std::vector<std::string> namesOrAll(const std::vector<std::string>& names)
    {
        return !names.empty()
            ? names
            : std::vector<std::string> { "cornell_box", "cornell_box_transparency", "monkey", "teapot", "dragon" };
    }

    // One sample a pixel with all that the features have, but for area lights' samples and textures' filters.
    worker::SpeedRequest requestFor(const std::string& scene, const Options& options)
    {
        const auto folder = std::filesystem::path(submission::sourceDirectory) / "scenes";
        worker::SpeedRequest request { .numRepetitions = options.numRepetitions };
        request.render.scene = (folder / (scene + ".toml")).string();
        request.render.size = app::parseSize(options.size);
        request.render.settings = { "accel_structure=true", "shading=true", "shadows=true", "reflections=true",
            "transparency=true", "texture_mapping=true", "normal_interp=true", "pixel_samples=1" };
        return request;
    }

    void measureScenes(const Options& options)
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
            files::writeText(options.json, nlohmann::json { { "rows", toJson(all) } }.dump(2) + "\n");
    }

    int run(const Options& options)
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

Command declareRender(CLI::App& cli)
{
    const auto options = std::make_shared<Options>();
    CLI::App& command = *cli.add_subcommand("render", "Whole frames beside the bare traversal of their rays");
    command.add_option("--scene", options->scenes, "A scene of the folder scenes; repeatable");
    command.add_option("--with", options->with, "Whose code: student, reference, or a submission's folder")
        ->capture_default_str();
    command.add_option("--size", options->size, "Pixels, as WIDTHxHEIGHT")->capture_default_str();
    command.add_option("--repetitions", options->numRepetitions, "Times that everybody has a turn")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command.add_option("--json", options->json, "Write the figures to this file");
    command.footer(
        "frame: renderImage. Its rays again: hits, by intersectRayWithBVH or BVH::intersect; traversal, by the "
        "library's tree alone. Small pictures and many repetitions are what a busy machine disturbs least.\n"
        "Exit codes: 0 done, 2 bad input, 70 the submission's code failed.");
    return { &command, [options] { return run(*options); } };
}

}
