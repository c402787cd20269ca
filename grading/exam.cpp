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
std::chrono::milliseconds Patience::left(const std::string& probe) const
{
    using Failure = worker::Failure;
    constexpr std::chrono::minutes inAll { 4 };
    const std::lock_guard lock(m_mutex);
    if (m_slowProbes.contains(probe))
        throw Failure(
            Failure::Kind::TimedOut, fmt::format("not asked: {} gave an earlier check no answer in time", probe));
    if (m_spent >= inAll)
        throw Failure(Failure::Kind::TimedOut, "not asked: the answers so far took four minutes");
    const std::chrono::seconds once { m_slowProbes.empty() ? 12 : 2 };
    return std::min<std::chrono::milliseconds>(once, std::chrono::ceil<std::chrono::milliseconds>(inAll - m_spent));
}

void Patience::wasAnswered(worker::Clock::duration after)
{
    const std::lock_guard lock(m_mutex);
    m_spent += after;
}

void Patience::wasNotAnswered(const std::string& probe, worker::Clock::duration waited)
{
    wasAnswered(waited);
    const std::lock_guard lock(m_mutex);
    m_slowProbes.insert(probe);
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
    worker::Answer answer = askInTime(probe, message, m_patience.left(probe));
    if (!answer.unwritten.empty())
        throw NotAttempted(answer.unwritten);
    return std::move(answer.output);
}

worker::Answer Exam::askInTime(const std::string& probe, const worker::Message& message, std::chrono::milliseconds time)
{
    const auto start = worker::Clock::now();
    const auto passed = [&] { return worker::Clock::now() - start; };
    try {
        if (!m_process)
            m_process = std::make_unique<worker::Process>(m_program, limits());
        worker::Answer answer = m_process->ask(probe, message, time);
        m_patience.wasAnswered(passed());
        return answer;
    } catch (const worker::Failure& failure) {
        if (failure.kind == worker::Failure::Kind::TimedOut)
            m_patience.wasNotAnswered(probe, passed());
        else
            m_patience.wasAnswered(passed());
        throw;
    }
}

}
