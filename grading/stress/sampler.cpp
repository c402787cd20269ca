#include "grading/stress/probes/sampler_questions.h"
#include "grading/stress/stress.h"
#include "grading/stress/text.h"
#include <cmath>
#include <span>

// The library's random numbers. next_1d keeps 24 bits of its state and makes a float of them, so there are no more than
// 2^24 numbers; when a stream has brought that many different ones, all of them in [0, 1), no state is left that could
// give another.
namespace stress::sampler {
namespace {

    // In standard deviations: a sequence without order exceeds it once in 1.7 million cases. Seeds are fixed, so what
    // holds once holds forever.
    constexpr double significant = 5.0;

    Judgement judgeDeviation(double deviations, const std::string& of)
    {
        if (std::abs(deviations) <= significant)
            return right();
        return wrong(fmt::format("{} {:.2f} standard deviations off", of, deviations),
            fmt::format("less than {} of them", significant));
    }

    // How uneven counts of equal cells are, in standard deviations of chi-square: near enough to normal.
    double unevenness(std::span<const uint64_t> cells, uint64_t count)
    {
        const double expected = static_cast<double>(count) / static_cast<double>(cells.size());
        double chiSquare = 0.0;
        for (const uint64_t cell : cells)
            chiSquare += std::pow(static_cast<double>(cell) - expected, 2.0) / expected;
        const auto freedom = static_cast<double>(cells.size() - 1);
        return (chiSquare - freedom) / std::sqrt(2.0 * freedom);
    }

    Judgement judgeCounts(const Counts& came, uint64_t count)
    {
        if (came.outside > 0 || came.between > 0)
            return wrong(fmt::format("{} outside of [0, 1), {} with more than 24 bits", came.outside, came.between),
                "multiples of 2^-24 in [0, 1)");
        const auto n = static_cast<double>(count);
        const double mean = (static_cast<double>(came.sum) / n + 0.5) * 0x1p-24;
        const Judgement judgement = judgeDeviation((mean - 0.5) * std::sqrt(12.0 * n), "the mean is");
        return judgement.isRight ? judgeDeviation(unevenness(came.cells, count), "256 cells are") : judgement;
    }

    std::string describeSeeds(const Seeds& query)
    {
        return fmt::format("the first number of {} seeds from {} on", query.count, query.first);
    }

    std::string describeStream(const Stream& query)
    {
        return fmt::format("{} numbers of seed {}", query.count, query.seed);
    }

    std::string describeCoverage(const Coverage& query)
    {
        return fmt::format("{} numbers of seed {}, or until there was each", query.most, query.seed);
    }

    std::string describeNeighbours(const Neighbours& query)
    {
        return fmt::format("the number {} of a pixel and the number {} of that {} to the right and {} down, {} x {} "
                           "pixels with seeds from {} on",
            query.number, query.neighboursNumber, query.right, query.down, query.width, query.height, query.seedOffset);
    }

    Judgement judgeSeeds(const Seeds& query, const Counts& came)
    {
        return judgeCounts(came, query.count);
    }

    Judgement judgeStream(const Stream& query, const Counts& came)
    {
        return judgeCounts(came, query.count);
    }

    Judgement judgeCoverage(const Coverage&, const Covered& came)
    {
        if (came.seen == 1u << 24 && came.outside == 0)
            return right();
        return wrong(fmt::format("{} different ones of {}, {} outside of [0, 1)", came.seen, came.drawn, came.outside),
            "all multiples of 2^-24 in [0, 1), and no other number");
    }

    // A product of two numbers about 0 has the variance 1/144.
    Judgement judgePairs(const Neighbours&, const Pairs& came)
    {
        const double deviations = came.product * 12.0 / std::sqrt(static_cast<double>(came.count));
        const Judgement judgement = judgeDeviation(deviations, "the correlation is");
        return judgement.isRight ? judgeDeviation(unevenness(came.cells, came.count), "16 x 16 cells are") : judgement;
    }

    const Question<Seeds, Counts> seeds { "stress.sampler_seeds", describeSeeds, judgeSeeds };
    const Question<Stream, Counts> stream { "stress.sampler_stream", describeStream, judgeStream };
    const Question<Coverage, Covered> coverage { "stress.sampler_coverage", describeCoverage, judgeCoverage };
    const Question<Neighbours, Pairs> neighbours { "stress.sampler_neighbours", describeNeighbours, judgePairs };

    // Twenty-six draws for each: that one is never seen has a probability of 1e-4, of which this seed has no part.
    const Stress allNumbers("sampler.numbers.all", coverage,
        constructed<Coverage>({ { "all numbers that there are", { 1, 26ull << 24 } } }));

    const Stress manySeeds("sampler.seeds.first", seeds,
        constructed<Seeds>({
            { "the first seeds", { 0, 1 << 24 } },
            { "the seeds about 2^31", { (1ull << 31) - (1 << 23), 1 << 24 } },
            { "the last seeds", { (1ull << 32) - (1 << 24), 1 << 24 } },
        }));

    const Stress sums("sampler.streams.sum", stream,
        constructed<Stream>({
            { "2^24 numbers of seed 0", { 0, 1 << 24 } },
            { "2^24 numbers of seed 1", { 1, 1 << 24 } },
            { "2^24 numbers of seed 2", { 2, 1 << 24 } },
            { "2^24 numbers of seed 2^31", { 1u << 31, 1 << 24 } },
            { "2^24 numbers of the last seed", { 0xffffffffu, 1 << 24 } },
            { "2^24 numbers of the golden seed", { 0x9e3779b9u, 1 << 24 } },
        }));

    constexpr uint32_t second = 0x9e3779b9u; // the offset of a picture with seed 1

    const Stress correlations("sampler.pixels.neighbours", neighbours,
        constructed<Neighbours>({
            { "side by side, first numbers", { 0, 1024, 1024, 1, 0, 0, 0 } },
            { "above each other, first numbers", { 0, 1024, 1024, 0, 1, 0, 0 } },
            { "diagonal, first numbers", { 0, 1024, 1024, 1, 1, 0, 0 } },
            { "two apart, first numbers", { 0, 1024, 1024, 2, 0, 0, 0 } },
            { "side by side, second numbers", { 0, 1024, 1024, 1, 0, 1, 1 } },
            { "above each other, second numbers", { 0, 1024, 1024, 0, 1, 1, 1 } },
            { "side by side, the second and the first", { 0, 1024, 1024, 1, 0, 1, 0 } },
            { "above each other, the second and the first", { 0, 1024, 1024, 0, 1, 1, 0 } },
            { "of one pixel, the first and the second", { 0, 1024, 1024, 0, 0, 0, 1 } },
            { "of one pixel, the first and the third", { 0, 1024, 1024, 0, 0, 0, 2 } },
            { "side by side, tenth numbers", { 0, 1024, 1024, 1, 0, 9, 9 } },
            { "side by side, another picture", { second, 1024, 1024, 1, 0, 0, 0 } },
            { "above each other, another picture", { second, 1024, 1024, 0, 1, 0, 0 } },
            { "above each other, 1,000 wide", { 0, 1000, 1000, 0, 1, 0, 0 } },
            { "above each other, 800 wide", { 0, 800, 800, 0, 1, 0, 0 } },
            { "above each other, 16,384 wide", { 0, 16384, 64, 0, 1, 0, 0 } },
        }));

}
}
