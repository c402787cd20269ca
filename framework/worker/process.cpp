#include "worker/process.h"
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <random>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace worker {
namespace {

    sandbox::Command commandOf(const std::filesystem::path& executable, const Limits& limits)
    {
        sandbox::Command command;
        command.words = { executable.string() };
        command.limits = { limits.memoryBytes, limits.outputBytes, limits.cpuTime };
        command.view.readable = limits.readable;
        command.view.readable.push_back(executable);
        if (!limits.treeFolder.empty()) {
            command.words.push_back(limits.treeFolder.string());
            command.view.writable = limits.treeFolder;
        }
        return command;
    }

}

Process::Process(const std::filesystem::path& executable, const Limits& limits)
    : m_answerBytes(limits.answerBytes)
    , m_nonce(std::random_device {}())
{
    int sockets[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
        throw std::system_error(errno, std::generic_category(), "socketpair");
    m_socket = sandbox::File(sockets[0]);
    const sandbox::File theirs { sockets[1] };
    if (limits.captureOutput)
        m_output = std::make_shared<Output>();
    sandbox::Command command = commandOf(executable, limits);
    command.socket = theirs;
    command.output = m_output ? m_output->descriptor() : -1;
    m_child.emplace(command);
}

Answer Process::ask(const std::string& probe, const Message& input, std::chrono::milliseconds timeout,
    const std::function<void(float)>& onProgress)
{
    const auto deadline = Clock::now() + timeout;
    Message request;
    request << probe;
    request.append(input.bytes().data(), input.bytes().size());
    ++m_nonce;
    // A worker that is gone is seen when its answer is read, with what it left.
    if (sendFrame(m_socket, { m_nonce, Frame::Kind::Request, std::move(request) }, deadline) == Transfer::TimedOut)
        fail(Transfer::TimedOut);
    for (;;) {
        Frame frame;
        const Transfer received = receiveFrame(m_socket, frame, m_answerBytes, deadline);
        if (received != Transfer::Done || frame.nonce != m_nonce)
            fail(received);
        Reader reader { frame.message };
        if (frame.kind == Frame::Kind::Failure)
            throw ProbeError(reader.read<std::string>());
        if (frame.kind == Frame::Kind::Answer) {
            constexpr std::size_t mostUnwritten = 100; // the interface has fewer functions
            if (Reader(frame.message).read<std::size_t>() > mostUnwritten)
                fail(Transfer::Done);
            Answer answer { reader.read<std::vector<std::string>>(), {} };
            answer.output.append(reader.rest().data(), reader.rest().size());
            return answer;
        }
        if (onProgress)
            onProgress(reader.read<float>());
    }
}

void Process::fail(Transfer transfer)
{
    if (transfer == Transfer::Closed)
        failAtEnd();
    m_child->kill();
    if (transfer == Transfer::TimedOut)
        throw Failure(Failure::Kind::TimedOut, "no answer in time");
    throw Failure(Failure::Kind::Malformed, "the answer is not one to the question");
}

void Process::failAtEnd()
{
    using Kind = Failure::Kind;
    // Usually the socket closed because the process ended; one that closed it and goes on gets no time to explain.
    constexpr std::chrono::milliseconds patience { 200 };
    const bool hasEnded = m_child->hasEndedBy(sandbox::Clock::now() + patience);
    const sandbox::Child::End end = m_child->kill();
    if (!hasEnded)
        throw Failure(Kind::Crashed, "closed its connection" + lastPrinted());
    if (end.signal == 0)
        throw Failure(Kind::Crashed, "ended by itself with exit code " + std::to_string(end.exitCode) + lastPrinted());
    // The first is the limit on the processor's time, the second the end of those who ignore it (or, seldom, of whoever
    // is largest when a machine has no memory left).
    const bool isTimedOut = end.signal == SIGXCPU || end.signal == SIGKILL;
    const char* const name = sigdescr_np(end.signal);
    throw Failure(isTimedOut ? Kind::TimedOut : Kind::Crashed,
        std::string(name ? name : "signal") + " (signal " + std::to_string(end.signal) + ")" + lastPrinted());
}

// What an assertion or a sanitizer says stands at the end of what was printed.
std::string Process::lastPrinted() const
{
    constexpr std::size_t tail = 300; // characters
    const std::string text = m_output ? m_output->last(tail) : "";
    return text.empty() ? text : "; it printed last: " + text;
}

}
