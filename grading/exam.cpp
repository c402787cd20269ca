#include "grading/exam.h"
#include "grading/worker_limits.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grading {
namespace {

    worker::Limits limits()
    {
        worker::Limits limits = limitsOfWorkers();
        limits.cpuTime
            = std::chrono::seconds(60); // the slowest check, undecided to the end, takes the reference twenty
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

// Wall-clock time, on a machine that may be busy. The checks of a feature take the reference three seconds.
std::chrono::milliseconds Patience::left() const
{
    constexpr std::chrono::minutes inAll { 4 };
    const std::chrono::seconds once { slowProbes.empty() ? 12 : 2 };
    const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(inAll - spent);
    return std::clamp<std::chrono::milliseconds>(rest, std::chrono::milliseconds(0), once);
}

Exam::Exam(std::filesystem::path submission, ExpectedAnswers& expected, Random random_, Patience& patience)
    : random(std::move(random_))
    , m_program(std::move(submission))
    , m_expected(expected)
    , m_patience(patience)
{
}

worker::Message Exam::runSubmission(const std::string& probe, const worker::Message& message)
{
    using Failure = worker::Failure;
    if (m_patience.slowProbes.contains(probe))
        throw Failure(
            Failure::Kind::TimedOut, fmt::format("not asked: {} gave an earlier check no answer in time", probe));
    if (m_patience.left().count() == 0)
        throw Failure(Failure::Kind::TimedOut, "not asked: the answers so far took four minutes");
    worker::Answer answer = askInTime(probe, message);
    if (!answer.unwritten.empty())
        throw NotAttempted(answer.unwritten);
    return std::move(answer.output);
}

worker::Answer Exam::askInTime(const std::string& probe, const worker::Message& message)
{
    const auto start = worker::Clock::now();
    try {
        if (!m_process)
            m_process = std::make_unique<worker::Process>(m_program, limits());
        worker::Answer answer = m_process->ask(probe, message, m_patience.left());
        m_patience.spent += worker::Clock::now() - start;
        return answer;
    } catch (const worker::Failure& failure) {
        m_patience.spent += worker::Clock::now() - start;
        if (failure.kind == worker::Failure::Kind::TimedOut)
            m_patience.slowProbes.insert(probe);
        throw;
    }
}

}
