#pragma once
#include "grading/expected.h"
#include "grading/random.h"
#include "grading/row.h"
#include "worker/process.h"
#include <filesystem>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>

namespace grading {

// The submission's answer is not right.
class Wrong : public std::runtime_error {
public:
    Wrong(const std::string& asked, const std::string& came, const std::string& expected);
};

// The submission met functions that are still stubs.
class NotAttempted : public std::runtime_error {
public:
    explicit NotAttempted(const std::vector<std::string>& functions);

    std::vector<std::string> functions;
};

// How long a submission may take for an answer. An endless loop is met by many checks, and a teacher has three hundred
// folders: a probe that was not answered in time is not asked again, after the first of them there is less patience,
// and there is an end to it in all. Shared by checks that run side by side.
class Patience {
public:
    // For the next answer to a probe. Throws worker::Failure when it is not to be asked.
    [[nodiscard]] std::chrono::milliseconds left(const std::string& probe) const;

    void wasAnswered(worker::Clock::duration after);
    void wasNotAnswered(const std::string& probe, worker::Clock::duration waited);

private:
    mutable std::mutex m_mutex;
    std::set<std::string> m_slowProbes;
    worker::Clock::duration m_spent {}; // on all answers so far
};

// One check on one submission: its random inputs, its worker and the reference's answers. The worker starts when it is
// first asked; a check never sees what another one left behind.
class Exam {
public:
    Exam(std::filesystem::path submission, ExpectedAnswers& expected, Random random, Patience& patience);

    Random random;
    std::shared_ptr<const PicturePair> pictures; // what the check compared, for the report

    // Asks the submission's worker: writes the inputs, reads a Result.
    // Throws NotAttempted, and worker::Failure when it crashes, takes too long or does not answer to the point.
    template <typename Result, typename... Inputs>
    [[nodiscard]] Result ask(const std::string& probe, const Inputs&... inputs)
    {
        return get<Result>([&](const worker::Message& message) { return runSubmission(probe, message); }, inputs...);
    }

    // Asks the reference. The inputs must depend neither on the submission nor on `random`: answers are kept. Throws
    // std::runtime_error when there is none.
    template <typename Result, typename... Inputs>
    [[nodiscard]] Result askReference(const std::string& probe, const Inputs&... inputs)
    {
        return get<Result>(
            [&](const worker::Message& message) { return m_expected.answer(probe, message); }, inputs...);
    }

    // Whether to ask the reference also what only other submissions make necessary.
    [[nodiscard]] bool wantsAllAnswers() const { return m_expected.wantsAll(); }

private:
    template <typename Result, typename Run, typename... Inputs>
    Result get(const Run& runProbe, const Inputs&... inputs)
    {
        worker::Message message;
        (message << ... << inputs);
        const worker::Message answer = runProbe(message);
        worker::Reader reader { answer };
        return reader.read<Result>();
    }

    worker::Message runSubmission(const std::string& probe, const worker::Message& message);
    worker::Answer askInTime(const std::string& probe, const worker::Message& message, std::chrono::milliseconds time);

    std::filesystem::path m_program;
    std::unique_ptr<worker::Process> m_process;
    ExpectedAnswers& m_expected;
    Patience& m_patience;
};

}
