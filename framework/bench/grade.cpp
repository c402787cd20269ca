#include "bench/grade.h"
#include "app/run_command.h"
#include "bench/grader.h"
#include "files/text.h"
#include "submission/features.h"
#include "submission/paths.h"
#include <algorithm>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace bench {
namespace {

    namespace fs = std::filesystem;

    struct Options {
        std::string submission = (fs::path(submission::sourceDirectory) / "reference").string();
        std::string json;
        int numRounds = 3;
    };

    // What the grader knows before it grades, and how long that takes, once a round.
    struct Case {
        std::string name;
        std::function<void(Grader&)> prepare;
        std::vector<GradeTimes> rounds {};

        // The round in the middle: its parts add up to its whole.
        [[nodiscard]] const GradeTimes& typical() const { return rounds[rounds.size() / 2]; }
    };

    std::vector<Case> makeCases(const fs::path& submission)
    {
        std::vector<std::string> names;
        for (const std::string& name : submission::features)
            if (fs::exists(submission / (name + ".cpp")))
                names.push_back(name);
        const auto changeAll = [names](Grader& grader) {
            for (const std::string& name : names)
                grader.change(name);
        };
        std::vector<Case> cases { { "first on a machine", [](Grader& grader) { grader.forgetAll(); } },
            { "files never seen", changeAll }, { "the same files", [](Grader&) {} } };
        for (const std::string& name : names)
            cases.push_back({ name + " changed", [name](Grader& grader) { grader.change(name); } });
        return cases;
    }

    void showProgress(const std::string& what)
    {
        if (isatty(STDERR_FILENO))
            fmt::print(stderr, "\r\033[K{}", what);
    }

    void measure(std::vector<Case>& cases, const Options& options)
    {
        Grader grader { options.submission };
        for (int round = 1; round <= options.numRounds; ++round) {
            for (Case& each : cases) {
                showProgress(fmt::format("round {} of {}: {}", round, options.numRounds, each.name));
                each.prepare(grader);
                each.rounds.push_back(grader.grade());
            }
        }
        showProgress("");
        for (Case& each : cases)
            std::ranges::sort(each.rounds, {}, &GradeTimes::total);
    }

    const Case& neverSeen(const std::vector<Case>& cases)
    {
        return cases[1];
    }

    void print(const std::vector<Case>& cases)
    {
        fmt::print("seconds, the middle of {} rounds\n{:<22} {:>6} {:<16} {:>8} {:>6} {:>7} {:>13}\n",
            cases[0].rounds.size(), "", "total", "", "building", "asking", "drawing", "start, report");
        for (const Case& each : cases) {
            const GradeTimes& times = each.typical();
            const std::string spread
                = fmt::format("({:.2f} to {:.2f})", each.rounds.front().total, each.rounds.back().total);
            fmt::print("{:<22} {:>6.2f} {:<16} {:>8.2f} {:>6.2f} {:>7.2f} {:>13.2f}\n", each.name, times.total, spread,
                times.building, times.asking, times.drawing, times.rest());
        }
        fmt::print(
            "\n{:<22} {:>9} {:>7} {:>6}   side by side\n", neverSeen(cases).name, "compiling", "linking", "asking");
        for (const auto& [name, file] : neverSeen(cases).typical().files)
            fmt::print("  {:<20} {:>9.2f} {:>7.2f} {:>6.2f}\n", name, file.compiling, file.linking, file.asking);
    }

    nlohmann::ordered_json toJson(const std::vector<Case>& cases)
    {
        nlohmann::ordered_json json { { "cases", nlohmann::ordered_json::array() },
            { "files", nlohmann::ordered_json::object() } };
        for (const Case& each : cases) {
            const GradeTimes& times = each.typical();
            json["cases"].push_back({ { "name", each.name }, { "total", times.total },
                { "least_total", each.rounds.front().total }, { "most_total", each.rounds.back().total },
                { "building", times.building }, { "asking", times.asking }, { "drawing", times.drawing },
                { "starting_and_reporting", times.rest() } });
        }
        for (const auto& [name, file] : neverSeen(cases).typical().files)
            json["files"][name]
                = { { "compiling", file.compiling }, { "linking", file.linking }, { "asking", file.asking } };
        return json;
    }

    int run(const Options& options)
    {
        std::vector<Case> cases = makeCases(options.submission);
        try {
            measure(cases, options);
        } catch (const GraderFailed& failure) {
            showProgress("");
            fmt::print(stderr, "{}\n", failure.what());
            return app::Unavailable;
        }
        print(cases);
        if (!options.json.empty())
            files::writeText(options.json, toJson(cases).dump(2) + "\n");
        return app::Success;
    }

}

Command declareGrade(CLI::App& cli)
{
    const auto options = std::make_shared<Options>();
    CLI::App& command = *cli.add_subcommand("grade", "Gradings of a submission, by what is known before, in parts");
    command.add_option("submission", options->submission, "A folder with a submission's files [the reference]");
    command.add_option("--json", options->json, "Write the figures to this file");
    command.add_option("--rounds", options->numRounds, "Times that each is graded")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command.footer("Exit codes: 0 done, 2 bad input, 69 the grader is not there or failed.");
    return { &command, [options] { return run(*options); } };
}

}
