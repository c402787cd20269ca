#pragma once
#include "worker/frame.h"
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace worker {

struct Limits {
    std::optional<std::size_t> memoryBytes; // of address space
    std::optional<std::size_t> outputBytes; // printed, when captured
    std::size_t answerBytes = std::size_t(64) << 20; // of one answer
    bool captureOutput = true; // otherwise what it prints goes where ours goes
};

// How a request can fail. The worker is gone afterwards.
class Failure : public std::runtime_error {
public:
    enum class Kind { Crashed, TimedOut, Malformed };

    Failure(Kind kind_, const std::string& message)
        : std::runtime_error(message)
        , kind(kind_)
    {
    }

    Kind kind;
};

// The probe answered with an error of its own, such as a file that cannot be read. The worker lives on.
class ProbeError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct Answer {
    std::vector<std::string> unwritten; // functions that are still stubs and were met
    Message output;
};

// A worker and its process group, killed when this goes.
class Process {
public:
    Process(const std::filesystem::path& executable, const Limits& limits);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // Runs a probe. Throws Failure or ProbeError.
    [[nodiscard]] Answer ask(const std::string& probe, const Message& input, std::chrono::milliseconds timeout,
        const std::function<void(float)>& onProgress = {});

private:
    [[noreturn]] void fail(Transfer transfer);
    [[nodiscard]] std::string describeEnd();
    [[nodiscard]] std::string lastPrinted() const;
    void kill();

    int m_socket = -1;
    int m_output = -1; // a file in memory, -1 if not captured
    pid_t m_pid = -1;
    std::size_t m_answerBytes;
    uint64_t m_nonce;
};

}
