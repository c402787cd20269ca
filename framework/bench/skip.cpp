#include "bench/skip.h"
#include "app/number_pairs.h"
#include "app/renderer.h"
#include "app/run_command.h"
#include "files/text.h"
#include "submission/paths.h"
#include "worker/skip_times.h"
#include "worker/speed.h"
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    namespace fs = std::filesystem;

    struct Options {
        std::vector<std::string> scenes; // of the folder scenes; empty: all
        std::string with = "reference";
        std::string size = "96x96";
        std::string json;
        uint32_t numRepetitions = 25;
        uint32_t numRounds = 8;
    };

    std::vector<std::string> namesOrAll(std::vector<std::string> names)
    {
        if (names.empty())
            for (const auto& entry : fs::directory_iterator(fs::path(submission::sourceDirectory) / "scenes"))
                if (entry.path().extension() == ".toml")
                    names.push_back(entry.path().stem().string());
        std::ranges::sort(names);
        return names;
    }

    // One sample a pixel, and all features on: what is left out is left out because of the scene.
    worker::SpeedRequest requestFor(const std::string& scene, const Options& options)
    {
        const auto folder = fs::path(submission::sourceDirectory) / "scenes";
        worker::SpeedRequest request { .numRepetitions = options.numRepetitions };
        request.render.scene = (folder / (scene + ".toml")).string();
        request.render.size = app::parseSize(options.size);
        request.render.settings = { "accel_structure=true", "shading=true", "shadows=true", "reflections=true",
            "transparency=true", "texture_mapping=true", "bilinear_filtering=true", "normal_interp=true",
            "pixel_samples=1", "shadow_samples=4" };
        return request;
    }

    void append(std::vector<double>& times, const std::vector<double>& more)
    {
        times.insert(times.end(), more.begin(), more.end());
    }

    void add(worker::SkipTimes& all, const worker::SkipTimes& round)
    {
        append(all.skipping, round.skipping);
        append(all.without, round.without);
        append(all.specialised, round.specialised);
        all.isSame = all.isSame && round.isSame;
        all.farthest = std::max(all.farthest, round.farthest);
    }

    // Of each scene. What disturbs a machine for seconds meets other scenes in the next round.
    std::vector<worker::SkipTimes> measure(const std::vector<std::string>& scenes, const Options& options)
    {
        app::Renderer renderer(options.with);
        std::vector<worker::SkipTimes> all(scenes.size(), { .isSame = true });
        for (uint32_t round = 0; round < options.numRounds; ++round)
            for (std::size_t i = 0; i < scenes.size(); ++i)
                add(all[i], renderer.ask<worker::SkipTimes>("render.skip", requestFor(scenes[i], options)));
        return all;
    }

    // Ratios of the shortest times: whatever else the machine does only adds to a time.
    nlohmann::json rowFor(const std::string& scene, const worker::SkipTimes& times)
    {
        const double skipping = std::ranges::min(times.skipping);
        return { { "name", scene }, { "over_floor", skipping / std::ranges::min(times.specialised) },
            { "over_without", skipping / std::ranges::min(times.without) }, { "milliseconds", 1e3 * skipping },
            { "same", times.isSame }, { "floor_differs_by", times.farthest } };
    }

    void print(const nlohmann::json& row)
    {
        fmt::print("{:<32} {:>8.2f} {:>12.3f} {:>10.3f}   {}, {:.1g}\n", row["name"].get<std::string>(),
            row["milliseconds"].get<double>(), row["over_without"].get<double>(), row["over_floor"].get<double>(),
            row["same"].get<bool>() ? "same" : "DIFFERENT", row["floor_differs_by"].get<double>());
    }

    // Whether all pictures are the same.
    bool report(const Options& options)
    {
        const std::vector<std::string> scenes = namesOrAll(options.scenes);
        const std::vector<worker::SkipTimes> all = measure(scenes, options);
        nlohmann::json rows = nlohmann::json::array();
        fmt::print("{:<32} {:>8} {:>12} {:>10}   pictures\n", "scene", "ms", "over without", "over floor");
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            rows.push_back(rowFor(scenes[i], all[i]));
            print(rows.back());
        }
        if (!options.json.empty())
            files::writeText(options.json, nlohmann::json { { "scenes", rows } }.dump(2) + "\n");
        return std::ranges::all_of(all, &worker::SkipTimes::isSame);
    }

    int run(const Options& options)
    {
        try {
            return report(options) ? app::Success : 1;
        } catch (const worker::Failure& failure) {
            fmt::print(stderr, "the code of {} failed: {}\n", options.with, failure.what());
            return app::SubmissionFailed;
        }
    }

}

Command declareSkip(CLI::App& cli)
{
    const auto options = std::make_shared<Options>();
    CLI::App& command = *cli.add_subcommand("skip", "What it is worth to leave out what a scene does not need");
    command.add_option("--scene", options->scenes, "A scene of the folder scenes; repeatable [all]");
    command.add_option("--with", options->with, "Whose code: student, reference, or a submission's folder")
        ->capture_default_str();
    command.add_option("--size", options->size, "Pixels, as WIDTHxHEIGHT")->capture_default_str();
    command.add_option("--rounds", options->numRounds, "Times that all scenes are gone through")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command.add_option("--repetitions", options->numRepetitions, "Times that everybody has a turn in each")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command.add_option("--json", options->json, "Write the figures to this file");
    command.footer(
        "Times with skipping over those without, and over those of code that was compiled for the parts that "
        "the scene has; last, how far the latter's pixels are from the reference's.\n"
        "Exit codes: 0 done, 1 skipping changes a picture, 2 bad input, 70 the submission's code failed.");
    return { &command, [options] { return run(*options); } };
}

}
