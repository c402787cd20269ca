#pragma once
#include "grading/random.h"
#include "worker/process.h"
#include <filesystem>
#include <memory>
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
};

// One check on one submission: its random inputs and its two workers. Each starts when it is first asked; a check never
// sees what another one left behind.
class Exam {
public:
    Exam(std::filesystem::path submission, std::filesystem::path reference, Random random);

    Random random;

    // Asks the submission's worker: writes the inputs, reads a Result.
    // Throws NotAttempted, and worker::Failure when it crashes, takes too long or does not answer to the point.
    template <typename Result, typename... Inputs>
    [[nodiscard]] Result ask(const std::string& probe, const Inputs&... inputs)
    {
        return get<Result>(m_submission, probe, inputs...);
    }

    // Asks the reference's.
    template <typename Result, typename... Inputs>
    [[nodiscard]] Result askReference(const std::string& probe, const Inputs&... inputs)
    {
        return get<Result>(m_reference, probe, inputs...);
    }

private:
    struct Side {
        std::filesystem::path program;
        std::unique_ptr<worker::Process> process;
    };

    template <typename Result, typename... Inputs>
    Result get(Side& side, const std::string& probe, const Inputs&... inputs)
    {
        worker::Message message;
        (message << ... << inputs);
        const worker::Message answer = run(side, probe, message);
        worker::Reader reader { answer };
        return reader.read<Result>();
    }

    worker::Message run(Side& side, const std::string& probe, const worker::Message& message);

    Side m_submission;
    Side m_reference;
};

}
