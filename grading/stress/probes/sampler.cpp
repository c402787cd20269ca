#include "sampler.h"
#include "grading/stress/probes/answer_all.h"
#include "grading/stress/probes/sampler_questions.h"

namespace stress {
namespace {

    constexpr uint64_t numValues = 1u << 24;

    bool isInside(float number)
    {
        return number >= 0.0f && number < 1.0f;
    }

    void add(Counts& counts, float number)
    {
        if (!isInside(number)) {
            ++counts.outside;
            return;
        }
        const float scaled = number * 0x1p24f;
        const auto steps = static_cast<uint32_t>(scaled);
        counts.between += static_cast<float>(steps) != scaled;
        counts.sum += steps;
        ++counts.cells[steps >> 16];
    }

    const worker::Probe seeds("stress.sampler_seeds", [](worker::Call& call) {
        answerAll<Seeds>(call, [](const Seeds& query) {
            Counts counts;
            for (uint64_t seed = query.first; seed < query.first + query.count; ++seed)
                add(counts, Sampler(static_cast<uint32_t>(seed)).next_1d());
            return counts;
        });
    });

    const worker::Probe stream("stress.sampler_stream", [](worker::Call& call) {
        answerAll<Stream>(call, [](const Stream& query) {
            Counts counts;
            Sampler sampler(query.seed);
            for (uint64_t i = 0; i < query.count; ++i)
                add(counts, sampler.next_1d());
            return counts;
        });
    });

    const worker::Probe coverage("stress.sampler_coverage", [](worker::Call& call) {
        answerAll<Coverage>(call, [](const Coverage& query) {
            std::vector<bool> isSeen(numValues);
            Covered covered;
            Sampler sampler(query.seed);
            for (; covered.seen < numValues && covered.drawn < query.most; ++covered.drawn) {
                const float number = sampler.next_1d();
                if (!isInside(number)) {
                    ++covered.outside;
                    continue;
                }
                auto value = isSeen[static_cast<uint32_t>(number * 0x1p24f)];
                covered.seen += !value;
                value = true;
            }
            return covered;
        });
    });

    float numberOf(const Neighbours& query, int x, int y, int number)
    {
        Sampler sampler(query.seedOffset + static_cast<uint32_t>(y * query.width + x));
        for (int i = 0; i < number; ++i)
            (void)sampler.next_1d();
        return sampler.next_1d();
    }

    const worker::Probe neighbours("stress.sampler_neighbours", [](worker::Call& call) {
        answerAll<Neighbours>(call, [](const Neighbours& query) {
            Pairs pairs;
            for (int y = 0; y < query.height - query.down; ++y) {
                for (int x = 0; x < query.width - query.right; ++x) {
                    const float a = numberOf(query, x, y, query.number);
                    const float b = numberOf(query, x + query.right, y + query.down, query.neighboursNumber);
                    ++pairs.count;
                    pairs.product += (static_cast<double>(a) - 0.5) * (static_cast<double>(b) - 0.5);
                    ++pairs.cells[static_cast<std::size_t>(a * 16.0f) * 16 + static_cast<std::size_t>(b * 16.0f)];
                }
            }
            return pairs;
        });
    });

}
}
