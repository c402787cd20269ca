#include "grading/exam.h"
#include "grading/worker_limits.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grading {
namespace {

    worker::Limits limits()
    {
        worker::Limits limits = limitsOfWorkers();
        limits.cpuTime = std::chrono::seconds(8); // the slowest check takes the reference one
        return limits;
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

// Wall-clock time, on a machine that may be busy: the limit on the processor's time is met first by all but sleepers.
std::chrono::milliseconds Patience::left() const
{
    return slowProbes.empty() ? std::chrono::seconds(12) : std::chrono::seconds(2);
}

Exam::Exam(std::filesystem::path submission, ExpectedAnswers& expected, Random random_, Patience& patience)
    : random(std::move(random_))
    , m_submission { std::move(submission), nullptr }
    , m_expected(expected)
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
