#include "bench/adaptive.h"
#include "app/number_pairs.h"
#include "app/render_goal.h"
#include "app/renderer.h"
#include "app/run_command.h"
#include "bench/picture_error.h"
#include "files/text.h"
#include "submission/paths.h"
#include "worker/adaptive_request.h"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    struct Options {
        std::string scene = "cornell_box_parallelogram_light";
        std::string with = "reference";
        std::string size = "128x128";
        std::string error = "0.01";
        std::string json;
        uint32_t numReferenceSamples = 4096;
        uint32_t numRepetitions = 3;
    };

    // So many independent samples in every pixel.
    struct Rival {
        std::string name;
        std::vector<std::string> settings;
        uint32_t numSamples = 64;
        double error = 0.0;
        std::vector<double> seconds, ratios; // one a repetition: its time, and over the adaptive one's
    };

    class Contest {
    public:
        explicit Contest(const Options& options)
            : m_renderer(options.with)
            , m_goal(app::parseGoal(options.error, ""))
        {
            const auto folder = std::filesystem::path(submission::sourceDirectory) / "scenes";
            m_request.scene = (folder / (options.scene + ".toml")).string();
            m_request.size = app::parseSize(options.size);
            // Other numbers than any rival's, and not the code that is judged: as many evenly spread samples
            // everywhere.
            m_reference = renderFixed({ "owen_sampling=true", "shadow_samples=1" }, options.numReferenceSamples).pixels;
            m_error = pictureError(renderAdaptive().rendering.pixels, m_reference);
        }

        // As many samples as make its error ours: the error of independent ones falls as their root.
        void level(Rival& rival)
        {
            const double ratio = errorOf(rival) / m_error;
            rival.numSamples = static_cast<uint32_t>(std::clamp(rival.numSamples * ratio * ratio, 1.0, 0x1p20));
            rival.error = errorOf(rival);
        }

        // Everybody has a turn.
        void run(std::vector<Rival>& rivals)
        {
            m_last = renderAdaptive();
            m_seconds.push_back(m_last.rendering.seconds);
            for (Rival& rival : rivals) {
                rival.seconds.push_back(renderFixed(rival.settings, rival.numSamples).seconds);
                rival.ratios.push_back(rival.seconds.back() / m_seconds.back());
            }
        }

        [[nodiscard]] double error() const { return m_error; }
        [[nodiscard]] const std::vector<double>& seconds() const { return m_seconds; }
        [[nodiscard]] const adaptive::Summary& summary() const { return m_last.summary; }
        [[nodiscard]] double samplesPerPixel() const
        {
            return static_cast<double>(summary().numSamples) / static_cast<double>(m_reference.size());
        }

    private:
        worker::Rendering renderFixed(std::vector<std::string> settings, uint32_t numSamples)
        {
            worker::RenderRequest request = m_request;
            request.settings = std::move(settings);
            request.settings.push_back(fmt::format("pixel_samples={}", numSamples));
            return m_renderer.ask<worker::Rendering>("render.image", request);
        }

        worker::AdaptiveRendering renderAdaptive()
        {
            return m_renderer.ask<worker::AdaptiveRendering>(
                "render.adaptive", worker::AdaptiveRequest { m_request, m_goal });
        }

        double errorOf(const Rival& rival)
        {
            return pictureError(renderFixed(rival.settings, rival.numSamples).pixels, m_reference);
        }

        app::Renderer m_renderer;
        adaptive::Goal m_goal;
        worker::RenderRequest m_request;
        std::vector<glm::vec3> m_reference;
        double m_error = 0.0;
        std::vector<double> m_seconds;
        worker::AdaptiveRendering m_last;
    };

    double median(std::vector<double> values)
    {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::ranges::nth_element(values, middle);
        return *middle;
    }

    void print(const Contest& contest, const std::vector<Rival>& rivals)
    {
        fmt::print("{:<34} {:>7} {:>9} {:>9}  {}\n", "", "samples", "error", "seconds", "times the first's");
        fmt::print("{:<34} {:>7.1f} {:>9.2e} {:>9.3f}  (error believed: {:.2e})\n", "where they are needed",
            contest.samplesPerPixel(), contest.error(), median(contest.seconds()), contest.summary().error);
        for (const Rival& rival : rivals) {
            const auto [least, most] = std::ranges::minmax(rival.ratios);
            fmt::print("{:<34} {:>7} {:>9.2e} {:>9.3f}  {:.1f} ({:.1f} to {:.1f})\n", rival.name, rival.numSamples,
                rival.error, median(rival.seconds), median(rival.ratios), least, most);
        }
    }

    nlohmann::json toJson(const Options& options, const Contest& contest, const std::vector<Rival>& rivals)
    {
        nlohmann::json json { { "scene", options.scene }, { "size", options.size },
            { "samples", contest.samplesPerPixel() }, { "error", contest.error() },
            { "believed_error", contest.summary().error }, { "largest_error", contest.summary().largestError },
            { "seconds", contest.seconds() }, { "rivals", nlohmann::json::array() } };
        for (const Rival& rival : rivals)
            json["rivals"].push_back({ { "name", rival.name }, { "samples", rival.numSamples },
                { "error", rival.error }, { "seconds", rival.seconds }, { "ratio", median(rival.ratios) } });
        return json;
    }

    void measure(const Options& options)
    {
        std::vector<Rival> rivals { { "uniform, the scene's light samples", {} },
            { "uniform, one sample a light", { "shadow_samples=1" } } };
        for (Rival& rival : rivals)
            rival.settings.insert(rival.settings.end(), { "jittered_sampling=false", "owen_sampling=false" });
        Contest contest(options);
        for (Rival& rival : rivals)
            contest.level(rival);
        for (uint32_t repetition = 0; repetition < options.numRepetitions; ++repetition)
            contest.run(rivals);
        print(contest, rivals);
        if (!options.json.empty())
            files::writeText(options.json, toJson(options, contest, rivals).dump(2) + "\n");
    }

    int run(const Options& options)
    {
        try {
            measure(options);
            return app::Success;
        } catch (const worker::Failure& failure) {
            fmt::print(stderr, "the code of {} failed: {}\n", options.with, failure.what());
            return app::SubmissionFailed;
        }
    }

}

Command declareAdaptive(CLI::App& cli)
{
    const auto options = std::make_shared<Options>();
    CLI::App& command = *cli.add_subcommand("adaptive", "render --error beside as many samples everywhere");
    command.add_option("--scene", options->scene, "A scene of the folder scenes")->capture_default_str();
    command.add_option("--with", options->with, "Whose code: student, reference, or a submission's folder")
        ->capture_default_str();
    command.add_option("--size", options->size, "Pixels, as WIDTHxHEIGHT")->capture_default_str();
    command.add_option("--error", options->error, "What no pixel is to be believed to err by")->capture_default_str();
    command.add_option("--reference", options->numReferenceSamples, "Samples a pixel of the picture that is the truth")
        ->capture_default_str()
        ->check(CLI::Range(1, 1 << 20));
    command.add_option("--repetitions", options->numRepetitions, "Times that everybody has a turn")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command.add_option("--json", options->json, "Write the figures to this file");
    command.footer("Exit codes: 0 done, 2 bad input, 70 the submission's code failed.");
    return { &command, [options] { return run(*options); } };
}

}
