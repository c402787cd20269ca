#include "grading/stress/asker.h"
#include "grading/harmless.h"
#include "grading/worker_limits.h"

namespace stress {
namespace {

    // Why there was no answer.
    struct Lost {
        std::string word;
        std::string message;
    };

    const std::string timedOut = "timed out";

    Lost lostBy(const worker::Failure& failure)
    {
        using Kind = worker::Failure::Kind;
        const bool isCrash = failure.kind == Kind::Crashed;
        return { isCrash ? "crashed" : failure.kind == Kind::TimedOut ? timedOut : "malformed", failure.what() };
    }

    worker::Limits limits()
    {
        worker::Limits limits = grading::limitsOfWorkers();
        limits.cpuTime = std::chrono::minutes(30); // of a worker that answers half of all that a patient user wants
        return limits;
    }

    // A kind has inputs of its own, whatever else there is.
    uint64_t seedOf(const Stress& kind, uint64_t seed)
    {
        Random random { seed, kind.name };
        const uint64_t high = random.seed();
        return high << 32 | random.seed();
    }

}

Asker::Asker(std::filesystem::path worker, uint64_t seed, std::chrono::seconds patience)
    : m_worker(std::move(worker))
    , m_seed(seed)
    , m_patience(patience)
{
}

void Asker::ask(const Stress& kind, const Range& range, Tally& tally)
{
    ask(kind, range, tally, m_patience);
}

void Asker::ask(const Stress& kind, const Range& range, Tally& tally, std::chrono::seconds patience)
{
    if (tally.isGivenUp())
        return tally.giveUpOn(range.count);
    Lost lost;
    try {
        return askAtOnce(kind, range, tally, patience);
    } catch (const worker::Failure& failure) {
        lost = lostBy(failure);
    } catch (const worker::ProbeError& error) {
        lost = { "threw", error.what() };
    } catch (const worker::MalformedMessage& error) {
        lost = { "malformed", error.what() };
    }
    m_process.reset();
    if (range.count > 1) { // less is asked, in less time
        const std::size_t half = range.count / 2;
        const auto less = std::min(patience, std::chrono::seconds(2));
        ask(kind, { range.first, half }, tally, less);
        ask(kind, { range.first + half, range.count - half }, tally, less);
        return;
    }
    const auto batch = kind.makeBatch(seedOf(kind, m_seed), range);
    tally.countLostWorker(lost.word == timedOut);
    tally.add({ range.first, lost.word, batch->describe(0), wrong(grading::harmless(lost.message), "an answer") });
}

void Asker::askAtOnce(const Stress& kind, const Range& range, Tally& tally, std::chrono::seconds patience)
{
    if (!m_process)
        m_process = std::make_unique<worker::Process>(m_worker, limits());
    const std::unique_ptr<const Batch> batch = kind.makeBatch(seedOf(kind, m_seed), range);
    const worker::Answer answer = m_process->ask(kind.probe, batch->question(), patience);
    if (!answer.unwritten.empty())
        return tally.addUnwritten(range.count, answer.unwritten);
    std::size_t numRight = 0;
    double ulps = 0.0;
    batch->judge(answer.output, [&](std::size_t i, Judgement judgement) {
        if (judgement.isRight) {
            ++numRight;
            ulps = std::max(ulps, judgement.ulps);
        } else {
            tally.add({ range.first + i, "wrong", batch->describe(i), std::move(judgement) });
        }
    });
    tally.addRight(numRight, ulps);
}

}
