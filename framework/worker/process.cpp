#include "worker/process.h"
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <random>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace worker {
namespace {

    [[noreturn]] void throwErrno(const char* what)
    {
        throw std::system_error(errno, std::generic_category(), what);
    }

    void limit(int resource, std::optional<std::size_t> bytes)
    {
        if (!bytes)
            return;
        const rlimit both { *bytes, *bytes };
        setrlimit(static_cast<__rlimit_resource>(resource), &both);
    }

    // Between fork and exec: only calls that are safe there.
    [[noreturn]] void becomeWorker(const char* executable, int socket, int output, const Limits& limits)
    {
        setpgid(0, 0); // so that it can be killed with what it starts
        prctl(PR_SET_PDEATHSIG, SIGKILL); // and goes when we are interrupted
        const int high = fcntl(socket, F_DUPFD, 10); // out of the way of what is put in place below
        const int print = output < 0 ? -1 : fcntl(output, F_DUPFD, 10);
        if (dup2(high, socketOfWorker) < 0)
            _exit(127);
        const int nothing = open("/dev/null", O_RDONLY);
        dup2(nothing, STDIN_FILENO);
        if (print >= 0) {
            dup2(print, STDOUT_FILENO);
            dup2(print, STDERR_FILENO);
            limit(RLIMIT_FSIZE, limits.outputBytes);
            signal(SIGXFSZ, SIG_IGN); // what is printed beyond is lost, and the worker goes on
        }
        limit(RLIMIT_AS, limits.memoryBytes);
        limit(RLIMIT_CORE, 0);
        close_range(socketOfWorker + 1, ~0u, 0);
        char* const arguments[] { const_cast<char*>(executable), nullptr };
        execv(executable, arguments);
        _exit(127);
    }

}

Process::Process(const std::filesystem::path& executable, const Limits& limits)
    : m_answerBytes(limits.answerBytes)
    , m_nonce(std::random_device {}())
{
    int sockets[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
        throwErrno("socketpair");
    m_socket = sockets[0];
    if (limits.captureOutput)
        m_output = memfd_create("output", MFD_CLOEXEC);
    const std::string path = executable.string();
    m_pid = fork();
    if (m_pid < 0)
        throwErrno("fork");
    if (m_pid == 0)
        becomeWorker(path.c_str(), sockets[1], m_output, limits);
    setpgid(m_pid, m_pid); // whoever of the two comes first
    close(sockets[1]);
}

Process::~Process()
{
    kill();
    close(m_socket);
    if (m_output >= 0)
        close(m_output);
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
        throw Failure(Failure::Kind::Crashed, describeEnd() + lastPrinted());
    kill();
    if (transfer == Transfer::TimedOut)
        throw Failure(Failure::Kind::TimedOut, "no answer in time");
    throw Failure(Failure::Kind::Malformed, "the answer is not one to the question");
}

std::string Process::describeEnd()
{
    // Usually the socket closed because the process ended; one that closed it and goes on gets no time to explain.
    constexpr int patience = 200; // milliseconds
    const auto process = static_cast<int>(syscall(SYS_pidfd_open, m_pid, 0));
    pollfd poller { process, POLLIN, 0 };
    poll(&poller, 1, patience);
    close(process);
    siginfo_t ended {};
    waitid(P_PID, static_cast<id_t>(m_pid), &ended, WEXITED | WNOWAIT | WNOHANG);
    kill();
    if (ended.si_pid == 0)
        return "closed its connection";
    if (ended.si_code == CLD_EXITED)
        return "ended by itself with exit code " + std::to_string(ended.si_status);
    const int signal = ended.si_status;
    const char* name = sigdescr_np(signal);
    return std::string(name ? name : "signal") + " (signal " + std::to_string(signal) + ")";
}

void Process::kill()
{
    if (m_pid < 0)
        return;
    ::kill(-m_pid, SIGKILL);
    while (waitpid(m_pid, nullptr, 0) < 0 && errno == EINTR) { }
    m_pid = -1;
}

// What an assertion or a sanitizer says stands at the end of what was printed.
std::string Process::lastPrinted() const
{
    if (m_output < 0)
        return {};
    constexpr off_t tail = 300; // characters
    const off_t size = std::max<off_t>(lseek(m_output, 0, SEEK_END), 0);
    std::string text(static_cast<std::size_t>(std::min(size, tail)), '\0');
    const ssize_t got = pread(m_output, text.data(), text.size(), size - static_cast<off_t>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    return text.empty() ? text : "; it printed last: " + text;
}

}
