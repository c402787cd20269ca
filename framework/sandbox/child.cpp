#include "sandbox/child.h"
#include "sandbox/bubblewrap.h"
#include "sandbox/file.h"
#include "sandbox/filter.h"
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace sandbox {
namespace {

    // Descriptors of the command, or of the Bubblewrap around it.
    enum Descriptor { Socket = 3, Info, Filter, First };

    // Memory in pages of two megabytes where a program takes much of it: a large scene is loaded in half the time.
    constexpr const char* largePages = "GLIBC_TUNABLES=glibc.malloc.hugetlb=1";

    [[noreturn]] void throwErrno(const char* what)
    {
        throw std::system_error(errno, std::generic_category(), what);
    }

    // All that is needed after fork, where memory must not be asked for.
    struct Start {
        std::vector<const char*> words;
        std::string folder;
        std::array<int, First> descriptors { -1, -1, -1, -1, -1, -1 }; // what becomes number 0, 1, ...
        Limits limits;
        const std::vector<sock_filter>* filter = nullptr; // to be set by the command itself
    };

    void limit(__rlimit_resource resource, std::size_t soft, std::size_t hard)
    {
        const rlimit both { soft, hard };
        setrlimit(resource, &both);
    }

    void setLimits(const Limits& limits)
    {
        limit(RLIMIT_CORE, 0, 0);
        limit(RLIMIT_NOFILE, 256, 256); // each may hold memory that RLIMIT_AS does not see
        if (limits.memoryBytes)
            limit(RLIMIT_AS, *limits.memoryBytes, *limits.memoryBytes);
        if (limits.fileBytes) {
            limit(RLIMIT_FSIZE, *limits.fileBytes, *limits.fileBytes);
            signal(SIGXFSZ, SIG_IGN); // what is written beyond is lost, and the command goes on
        }
        if (limits.cpuTime) { // the soft limit's signal has a name, the hard one's is SIGKILL
            const auto seconds = static_cast<std::size_t>(limits.cpuTime->count());
            limit(RLIMIT_CPU, seconds, seconds + 1);
        }
    }

    void placeDescriptors(std::array<int, First> from)
    {
        for (int& descriptor : from) // out of the way of what is put in place
            descriptor = descriptor < 0 ? -1 : fcntl(descriptor, F_DUPFD, 10);
        for (int i = 0; i < First; ++i)
            if (from[static_cast<std::size_t>(i)] >= 0 && dup2(from[static_cast<std::size_t>(i)], i) < 0)
                _exit(127);
        for (int i = Socket; i < First; ++i)
            if (from[static_cast<std::size_t>(i)] < 0)
                close(i);
        if (close_range(First, ~0u, 0) != 0)
            _exit(127);
    }

    // Between fork and exec: only calls that are safe there.
    [[noreturn]] void become(const Start& start)
    {
        setpgid(0, 0); // so that it can be killed with what it starts
        prctl(PR_SET_PDEATHSIG, SIGKILL); // and goes when we are interrupted
        if (chdir(start.folder.c_str()) != 0)
            _exit(127);
        placeDescriptors(start.descriptors);
        setLimits(start.limits);
        if (start.filter) {
            const sock_fprog program { static_cast<unsigned short>(start.filter->size()),
                const_cast<sock_filter*>(start.filter->data()) };
            if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0
                || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
                _exit(127);
        }
        const char* const environment[] { "PATH=/usr/bin:/bin", "LC_ALL=C", largePages, nullptr };
        execve(start.words[0], const_cast<char* const*>(start.words.data()), const_cast<char* const*>(environment));
        _exit(127);
    }

    // The filter as a file that Bubblewrap reads.
    File fileOf(const std::vector<sock_filter>& filter)
    {
        File file { memfd_create("filter", MFD_CLOEXEC) };
        const std::size_t size = filter.size() * sizeof(sock_filter);
        if (pwrite(file, filter.data(), size, 0) != static_cast<ssize_t>(size))
            throwErrno("the filter of system calls");
        return file;
    }

    // Bubblewrap says {"child-pid": 123, ...} as soon as there is a first process, and nothing if there is none.
    pid_t readFirst(int info)
    {
        std::string said;
        std::array<char, 256> part {};
        for (ssize_t got = 0; said.find('}') == said.npos && (got = read(info, part.data(), part.size())) != 0;)
            if (got > 0)
                said.append(part.data(), static_cast<std::size_t>(got));
            else if (errno != EINTR)
                break;
        const std::size_t number = said.find_first_of("0123456789");
        return number == said.npos ? -1 : std::atoi(said.c_str() + number);
    }

    File openProcess(pid_t pid)
    {
        return File(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
    }

    void waitFor(int process, int milliseconds)
    {
        pollfd poller { process, POLLIN, 0 };
        while (poll(&poller, 1, milliseconds) < 0 && errno == EINTR) { }
    }

    pid_t launch(const Start& start)
    {
        const pid_t pid = fork();
        if (pid < 0)
            throwErrno("fork");
        if (pid == 0)
            become(start);
        setpgid(pid, pid); // whoever of the two comes first
        return pid;
    }

    std::vector<const char*> pointersTo(const std::vector<std::string>& words)
    {
        std::vector<const char*> pointers;
        for (const std::string& word : words)
            pointers.push_back(word.c_str());
        pointers.push_back(nullptr);
        return pointers;
    }

}

Child::Child(const Command& command)
{
    const File nothing { open("/dev/null", O_RDONLY | O_CLOEXEC) };
    Start start { {}, "/", { nothing, command.output, command.output, command.socket, -1, -1 }, command.limits };
    if (!whyNoBubblewrap().empty()) {
        start.filter = command.mayStartProcesses ? nullptr : &systemCallFilter();
        start.folder = command.folder.string();
        start.words = pointersTo(command.words);
        m_pid = launch(start);
        return;
    }
    int pipe[2];
    if (pipe2(pipe, O_CLOEXEC) != 0)
        throwErrno("pipe");
    const File info { pipe[0] };
    File said { pipe[1] };
    const File filter = command.mayStartProcesses ? File() : fileOf(systemCallFilter());
    start.descriptors[Info] = said;
    start.descriptors[Filter] = filter;
    std::vector<std::string> words = bubblewrapWords(command.view, Info, filter < 0 ? -1 : Filter);
    words.insert(words.end(), { "--chdir", command.folder.string(), "--" });
    words.insert(words.end(), command.words.begin(), command.words.end());
    start.words = pointersTo(words);
    m_pid = launch(start);
    said = File(); // ours: what is left is the other side's
    m_first = openProcess(readFirst(info));
    if (m_first < 0) { // nothing of the command ran
        kill();
        throw std::system_error(EAGAIN, std::generic_category(), "Bubblewrap");
    }
}

Child::~Child()
{
    kill();
}

bool Child::hasEndedBy(Clock::time_point deadline) const
{
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    const File process = openProcess(m_pid);
    waitFor(process, static_cast<int>(std::clamp<long>(left, 0, 24L * 3600 * 1000)));
    siginfo_t ended {};
    waitid(P_PID, static_cast<id_t>(m_pid), &ended, WEXITED | WNOWAIT | WNOHANG);
    return ended.si_pid != 0;
}

Child::End Child::kill()
{
    if (m_pid < 0)
        return m_end;
    if (m_first >= 0) { // the first process is gone only after all others in its namespace: see pid_namespaces(7)
        (void)syscall(SYS_pidfd_send_signal, static_cast<int>(m_first), SIGKILL, nullptr, 0);
        waitFor(m_first, -1);
        m_first = File();
    }
    ::kill(-m_pid, SIGKILL);
    int status = 0;
    while (waitpid(m_pid, &status, 0) < 0 && errno == EINTR) { }
    m_pid = -1;
    if (WIFSIGNALED(status))
        m_end.signal = WTERMSIG(status);
    else
        m_end.exitCode = WEXITSTATUS(status);
    constexpr int signalled = 128; // a shell's way to say so, and Bubblewrap's
    if (m_end.exitCode > signalled && m_end.exitCode < signalled + NSIG)
        m_end = { -1, m_end.exitCode - signalled };
    return m_end;
}

}
