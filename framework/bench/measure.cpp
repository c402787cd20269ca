#include "bench/measure.h"

namespace bench {
namespace {

    constexpr std::size_t chunkSize = 4096, warmUpSize = 1024;

    double trace(Rival& rival, Question question)
    {
        return question == Question::Closest ? rival.traceClosest() : rival.traceOccluded();
    }

    // Distances may differ by what rounding does to them.
    bool isSame(float a, float b)
    {
        return a == b || std::abs(a - b) <= 1e-4f * std::max(std::abs(a), std::abs(b));
    }

    std::size_t countDisagreeing(const Rival& a, const Rival& b, Question question, std::size_t numRays)
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i < numRays; ++i)
            count += question == Question::Closest ? !isSame(a.distance(i), b.distance(i))
                                                   : a.isOccluded(i) != b.isOccluded(i);
        return count;
    }

    // As when the two halves of a pack of cards are let fall into one another: neighbours, who may share a tree, would
    // find it in the caches.
    std::size_t shuffled(std::size_t place, std::size_t count)
    {
        return place % 2 == 0 ? place / 2 : (count + 1) / 2 + place / 2;
    }

    struct Chunk {
        std::span<const Ray> warmUp, rays;
    };

    // All rivals and repetitions for one chunk. Who comes next finds the caches full of another's tree: a few other
    // rays fetch its own.
    void measureChunk(const Chunk& chunk, Question question, const Rivals& rivals, std::vector<Time>& times)
    {
        const std::size_t numRepetitions = times.front().repetitions.size();
        std::vector<double> shortest(rivals.size(), std::numeric_limits<double>::infinity());
        for (std::size_t repetition = 0; repetition < numRepetitions; ++repetition) {
            for (std::size_t turn = 0; turn < rivals.size(); ++turn) {
                const std::size_t i = shuffled((turn + repetition) % rivals.size(), rivals.size());
                rivals[i]->load(chunk.warmUp);
                trace(*rivals[i], question);
                rivals[i]->load(chunk.rays);
                const double seconds = trace(*rivals[i], question);
                times[i].repetitions[repetition] += seconds;
                shortest[i] = std::min(shortest[i], seconds);
            }
        }
        for (std::size_t i = 0; i < rivals.size(); ++i) {
            times[i].seconds += shortest[i];
            times[i].numDisagreeing += countDisagreeing(*rivals[0], *rivals[i], question, chunk.rays.size());
        }
    }

}

std::vector<Time> measure(const RaySet& set, const Rivals& rivals, int numRepetitions)
{
    std::vector<Time> times(rivals.size());
    for (Time& time : times)
        time.repetitions.resize(static_cast<std::size_t>(numRepetitions));
    const std::span rays = set.rays;
    for (std::size_t first = 0; first < rays.size(); first += chunkSize) {
        const std::size_t count = std::min(chunkSize, rays.size() - first);
        const auto warmUp = first >= warmUpSize ? rays.subspan(first - warmUpSize, warmUpSize)
                                                : rays.last(std::min(warmUpSize, rays.size()));
        measureChunk({ warmUp, rays.subspan(first, count) }, set.question, rivals, times);
    }
    return times;
}

}
