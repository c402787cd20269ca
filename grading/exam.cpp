#include "grading/exam.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grading {
namespace {

    // The slowest question takes the reference a second; a machine may be slow and busy.
    constexpr std::chrono::seconds patience { 10 };

    // A render's scene and picture take a tenth of that.
    constexpr worker::Limits limits { .memoryBytes = std::size_t(4) << 30, .outputBytes = std::size_t(1) << 20 };

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

Exam::Exam(std::filesystem::path submission, ExpectedAnswers& expected, Random random_, SlowProbes& slowProbes)
    : random(std::move(random_))
    , m_submission { std::move(submission), nullptr }
    , m_expected(expected)
    , m_slowProbes(slowProbes)
{
}

worker::Message Exam::run(Side& side, const std::string& probe, const worker::Message& message)
{
    if (!side.process)
        side.process = std::make_unique<worker::Process>(side.program, limits);
    worker::Answer answer = side.process->ask(probe, message, patience);
    if (!answer.unwritten.empty())
        throw NotAttempted(answer.unwritten);
    return std::move(answer.output);
}

worker::Message Exam::runSubmission(const std::string& probe, const worker::Message& message)
{
    using Failure = worker::Failure;
    if (m_slowProbes.contains(probe))
        throw Failure(
            Failure::Kind::TimedOut, fmt::format("not asked: {} gave an earlier check no answer in time", probe));
    try {
        return run(m_submission, probe, message);
    } catch (const Failure& failure) {
        if (failure.kind == Failure::Kind::TimedOut)
            m_slowProbes.insert(probe);
        throw;
    }
}

}
