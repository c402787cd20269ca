#include "grading/stress/report.h"
#include "grading/report.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace stress {
namespace {

    // The kinds of a feature together, cases rather than inputs.
    struct Sum {
        std::size_t cases = 0, failed = 0, unwritten = 0, random = 0, constructed = 0;
        double ulps = 0.0;

        void add(const Stress& kind, const Tally& tally)
        {
            const std::size_t each = kind.casesEach;
            cases += tally.asked * each;
            failed += tally.failed * each;
            unwritten += tally.unwritten * each;
            (kind.isRandom() ? random : constructed) += tally.asked * each;
            ulps = std::max(ulps, tally.largestUlps);
        }
    };

    Sum sumOf(const Report& report)
    {
        Sum sum;
        for (const auto& [kind, tally] : report.tallies)
            sum.add(*kind, tally);
        return sum;
    }

    std::string called(const Stress& kind, const Failure& failure)
    {
        return kind.isRandom() ? kind.name : fmt::format("{}, {}", kind.name, kind.names.at(failure.input));
    }

    std::string wordFor(const Tally& tally)
    {
        return tally.failed > 0 ? "failed" : tally.unwritten > 0 ? "not attempted" : "passed";
    }

    std::string rowOf(const Stress& kind, const Tally& tally)
    {
        return fmt::format("{:<34} {:>10} {:>9} {:>10.3g}  {}\n", kind.name, tally.asked * kind.casesEach,
            tally.failed * kind.casesEach, tally.largestUlps, wordFor(tally));
    }

    nlohmann::ordered_json jsonOf(const Sum& sum)
    {
        return { { "cases", sum.cases }, { "failed", sum.failed }, { "not_attempted", sum.unwritten },
            { "constructed", sum.constructed }, { "random", sum.random }, { "largest_error_ulps", sum.ulps } };
    }

    nlohmann::ordered_json jsonOf(const Report& report, const Stress& kind, const Failure& failure)
    {
        const auto& [isRight, ulps, came, expected] = failure.judgement;
        return { { "name", kind.name }, { "case", failure.input },
            { "called", kind.isRandom() ? "" : kind.names.at(failure.input) }, { "status", failure.word },
            { "asked", failure.asked }, { "came", grading::toUtf8(came) }, { "expected", expected }, { "ulps", ulps },
            { "again", reproduction(report, kind, failure) } };
    }

}

bool allPassed(const Report& report)
{
    const Sum sum = sumOf(report);
    return sum.failed == 0 && sum.unwritten == 0;
}

std::string reproduction(const Report& report, const Stress& kind, const Failure& failure)
{
    const std::string alone = report.alone.empty() ? "" : " --alone " + report.alone;
    return fmt::format("./raywork stress {}{} --only {} --seed {} --case {}", report.submission, alone, kind.name,
        report.seed, failure.input);
}

std::string paragraph(const Report& report, const Stress& kind, const Failure& failure)
{
    const auto& [isRight, ulps, came, expected] = failure.judgement;
    return fmt::format(
        "{}: {}\n  asked     {}\n  came      {}\n  expected  {}\n  off by    {:.3g} ulps\n  again     {}\n",
        called(kind, failure), failure.word, failure.asked, came, expected, ulps, reproduction(report, kind, failure));
}

std::string table(const Report& report)
{
    std::string text = fmt::format("{:<34} {:>10} {:>9} {:>10}\n", "", "cases", "failed", "ulps");
    for (const auto& [kind, tally] : report.tallies)
        text += rowOf(*kind, tally);
    text += "\n";
    for (const auto& [kind, tally] : report.tallies) {
        for (const Failure& failure : tally.failures)
            text += paragraph(report, *kind, failure) + "\n";
        if (tally.unwritten > 0)
            text += fmt::format("{}: not attempted: {}\n", kind->name, fmt::join(tally.unwrittenFunctions, ", "));
    }
    const Sum sum = sumOf(report);
    return text
        + fmt::format("{}: {} cases ({} random, {} constructed) in {:.1f} s, {} failed, {} not attempted\n",
            report.submission, sum.cases, sum.random, sum.constructed, report.seconds, sum.failed, sum.unwritten);
}

std::string json(const Report& report)
{
    std::map<std::string, Sum> sums;
    nlohmann::ordered_json failures = nlohmann::ordered_json::array();
    for (const auto& [kind, tally] : report.tallies) {
        sums[kind->feature].add(*kind, tally);
        for (const Failure& failure : tally.failures)
            failures.push_back(jsonOf(report, *kind, failure));
    }
    nlohmann::ordered_json features = nlohmann::ordered_json::object();
    for (const auto& [feature, sum] : sums)
        features[feature] = jsonOf(sum);
    nlohmann::ordered_json whole = jsonOf(sumOf(report));
    whole.update({ { "submission", report.submission }, { "seed", report.seed }, { "seconds", report.seconds },
        { "features", features }, { "failures", failures } });
    return whole.dump(2) + "\n";
}

}
