#pragma once
#include "sandbox/child.h"
#include "sandbox/file.h"
#include "worker/frame.h"
#include "worker/output.h"
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace worker {

// What a worker may have.
struct Limits {
    std::optional<std::size_t> memoryBytes; // of address space
    std::optional<std::size_t> outputBytes; // printed, when captured
    std::optional<std::chrono::seconds> cpuTime;
    std::size_t answerBytes = std::size_t(64) << 20; // of one answer
    bool captureOutput = true; // otherwise what it prints goes where ours goes
    std::vector<std::filesystem::path> readable; // files and folders beside its own program; "/" is everything
    std::filesystem::path treeFolder; // where it may keep trees of large scenes, and believes what it finds; else empty
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

// A worker, locked in as well as this machine can, and killed with all that it started when this goes.
class Process {
public:
    Process(const std::filesystem::path& executable, const Limits& limits);

    // Runs a probe. Throws Failure or ProbeError.
    [[nodiscard]] Answer ask(const std::string& probe, const Message& input, std::chrono::milliseconds timeout,
        const std::function<void(float)>& onProgress = {});

    // What it prints: null if not captured. It outlives the process, for whoever holds it.
    [[nodiscard]] const std::shared_ptr<Output>& output() const { return m_output; }

private:
    [[noreturn]] void fail(Transfer transfer);
    [[noreturn]] void failAtEnd();
    [[nodiscard]] std::string lastPrinted() const;

    sandbox::File m_socket;
    std::shared_ptr<Output> m_output;
    std::optional<sandbox::Child> m_child;
    std::size_t m_answerBytes;
    uint64_t m_nonce;
};

}
