#include "grading/options.h"
#include "grading/feature.h"
#include "submission/features.h"
#include "submission/paths.h"
#include <CLI/CLI.hpp>

namespace grading {
namespace {

    namespace fs = std::filesystem;

    std::vector<std::string> featureNames()
    {
        std::vector<std::string> names;
        for (const Feature& feature : gradedFeatures)
            names.push_back(feature.name);
        return names;
    }

    void declareJudge(CLI::App& cli, Options& options)
    {
        CLI::Option* const seed = cli.add_option("--seed", options.seed, "Of the random inputs [1]");
        cli.add_option("--secret-file", options.secretFile,
               "The random inputs follow from its contents, 16 bytes or more, which students do not know")
            ->excludes(seed);
        cli.add_option("--sandbox", options.sandbox,
               "auto: locked in if this machine can, and says if not; required: or not at all; off: limits alone")
            ->check(CLI::IsMember({ "auto", "required", "off" }));
        options.referenceWorker = std::string(submission::buildDirectory) + "/grading/reference-worker";
        cli.add_option("--reference-worker", options.referenceWorker, "The program whose answers are taken for right");
        CLI::Option* const golden
            = cli.add_option("--golden", options.golden, "Take the reference's answers from this file instead");
        golden->check(CLI::ExistingFile);
        cli.add_option("--record", options.record, "Write the reference's answers to this file, for any submission")
            ->excludes(golden)
            ->excludes(cli.get_option("submission"));
    }

    void declareOutputs(CLI::App& cli, Outputs& outputs)
    {
        cli.add_option("--json", outputs.json, "Write the grade to this file as well, after each check");
        cli.add_option("--html", outputs.html, "Write a page for the student, with the pictures, to this file");
        cli.add_option("--junit", outputs.junit, "Write JUnit's XML to this file");
        cli.add_option("--gradescope", outputs.gradescope, "Write Gradescope's results.json to this file");
        cli.add_option(
               "--hide", outputs.hidden, "Of checks like this, such as 'texture.*', show the name alone; repeatable")
            ->allow_extra_args(false);
    }

    // Returns the option that mutates.
    const CLI::Option* declareValidation(CLI::App& cli, ValidationOptions& options)
    {
        options.bank = fs::path(submission::sourceDirectory) / "tests" / "grading";
        CLI::App* group = cli.add_option_group("Validation", "of the grader itself");
        group->add_flag(
            "--validate", options.validate, "Grade wrong and right solutions, and print how often that errs");
        group->add_option("--gradings", options.gradings, "Of right solutions, by many seeds [1000]");
        group->add_option(
            "--sample", options.sample, "Grade only so many wrong solutions, and half as many right ones");
        group->add_option("--bank", options.bank, "Folder with the solutions [tests/grading]");
        return group
            ->add_option("--mutants", options.mutatedFiles,
                "Grade the reference with one small change, each in turn, in these files [all]")
            ->expected(0, -1)
            ->check(CLI::IsMember(submission::features));
    }

}

std::optional<int> parse(int argc, char** argv, Options& options)
{
    CLI::App cli { "Grades a submission.", "./raywork grade" };
    cli.add_option("submission", options.submission, "A folder with a submission's files, such as student");
    cli.add_option("--only", options.onlyFeature, "Grade this feature alone")->check(CLI::IsMember(featureNames()));
    declareJudge(cli, options);
    cli.add_option("--stress-points", options.stressPoints,
           "Ask a few of the cases of ./raywork stress too, for so many points beside the 100; 0 only shows what came")
        ->check(CLI::NonNegativeNumber);
    cli.add_flag("--fresh", options.isFresh, "Repeat also the checks that see nothing changed since the last time");
    cli.add_flag("--watch", options.isWatching, "Grade again after each change of a file, until interrupted");
    declareOutputs(cli, options.outputs);
    cli.add_option("--times", options.times, "Write the seconds that each part of the grading took to this file");
    const CLI::Option* const mutants = declareValidation(cli, options.validation);
    cli.callback([&options, mutants] {
        options.validation.seed = options.seed;
        options.validation.mutate = mutants->count() > 0;
        std::erase(options.validation.mutatedFiles, ""); // which stands for no value at all
        if (options.submission.empty() && options.record.empty() && !options.validation.wanted())
            throw CLI::RequiredError("submission");
    });
    cli.footer("Exit codes: 0 graded, whatever the score; 1 --validate or --mutants found mistakes of the grader; 2 "
               "bad input; 75 the grader failed.");
    try {
        cli.parse(argc, argv);
        return {};
    } catch (const CLI::ParseError& error) {
        constexpr int badInput = 2;
        return cli.exit(error) == 0 ? 0 : badInput;
    }
}

}
