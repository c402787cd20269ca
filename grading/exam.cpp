#include "grading/exam.h"
#include "submission/paths.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grading {
namespace {

    worker::Limits limits()
    {
        const std::filesystem::path root { submission::sourceDirectory };
        return { .memoryBytes = std::size_t(4) << 30,
            .outputBytes = std::size_t(1) << 20,
            .cpuTime = std::chrono::seconds(8), // the slowest check takes the reference one
            .readable = { root / "scenes", root / "grading" / "scenes" } };
    }

}

Wrong::Wrong(const std::string& asked, const std::string& came, const std::string& expected)
    : std::runtime_error(fmt::format("{}: came {}, expected {}", asked, came, expected))
{
}

NotAttempted::NotAttempted(const std::vector<std::string>& functions_)
    : std::runtime_error(fmt::format("not written yet: {}", fmt::join(functions_, ", ")))
    , functions(functions_)
{
}

// Wall-clock time, on a machine that may be busy: the limit on the processor's time is met first by all but
// sleepers.
std::chrono::milliseconds Patience::left() const
{
    return slowProbes.empty() ? std::chrono::seconds(12) : std::chrono::seconds(2);
}

Exam::Exam(std::filesystem::path submission, std::filesystem::path reference, Random random_, Patience& patience)
    : random(std::move(random_))
    , m_submission { std::move(submission), nullptr }
    , m_reference { std::move(reference), nullptr }
    , m_patience(patience)
{
}

worker::Message Exam::run(
    Side& side, const std::string& probe, const worker::Message& message, std::chrono::milliseconds timeout)
{
    if (!side.process)
        side.process = std::make_unique<worker::Process>(side.program, limits());
    worker::Answer answer = side.process->ask(probe, message, timeout);
    if (!answer.unwritten.empty())
        throw NotAttempted(answer.unwritten);
    return std::move(answer.output);
}

worker::Message Exam::runReference(const std::string& probe, const worker::Message& message)
{
    try {
        return run(m_reference, probe, message, std::chrono::minutes(1));
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("the reference's worker, asked for {}: {}", probe, error.what()));
    }
}

worker::Message Exam::runSubmission(const std::string& probe, const worker::Message& message)
{
    using Failure = worker::Failure;
    if (m_patience.slowProbes.contains(probe))
        throw Failure(
            Failure::Kind::TimedOut, fmt::format("not asked: {} gave an earlier check no answer in time", probe));
    try {
        return run(m_submission, probe, message, m_patience.left());
    } catch (const Failure& failure) {
        if (failure.kind == Failure::Kind::TimedOut)
            m_patience.slowProbes.insert(probe);
        throw;
    }
}

}
