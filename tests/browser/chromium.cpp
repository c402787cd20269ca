#include "chromium.h"
#include <array>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace browser {
namespace {

    std::array<int, 2> makePipe()
    {
        std::array<int, 2> ends {};
        if (pipe2(ends.data(), O_CLOEXEC) != 0)
            throw std::runtime_error("no pipe for Chromium");
        // Beyond 3 and 4, which are to become Chromium's: a dup2 to itself would keep O_CLOEXEC.
        for (int& end : ends) {
            const int high = fcntl(end, F_DUPFD_CLOEXEC, 10);
            close(end);
            end = high;
        }
        return ends;
    }

    std::vector<std::string> commandLine(const std::string& profile)
    {
        // Its sandbox wants namespaces or a set-uid helper; root in a container has neither, and the page is ours.
        return { "chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-sync",
            "--disable-dev-shm-usage", "--hide-scrollbars", "--remote-debugging-pipe", "--user-data-dir=" + profile };
    }

}

Chromium::Chromium(const std::string& profile)
{
    prctl(PR_SET_CHILD_SUBREAPER, 1); // so that its children can be waited for
    std::signal(SIGPIPE, SIG_IGN); // a Chromium that is gone shows in send
    const std::array<int, 2> to = makePipe();
    const std::array<int, 2> from = makePipe();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, to[0], 3);
    posix_spawn_file_actions_adddup2(&actions, from[1], 4);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0); // it complains of no bus
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::vector<std::string> arguments = commandLine(profile);
    std::vector<char*> pointers;
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const int error = posix_spawnp(&m_pid, "chromium", &actions, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    close(to[0]);
    close(from[1]);
    m_to = to[1];
    m_from = from[0];
    if (error != 0)
        throw std::runtime_error("chromium cannot be started; is it installed?");
}

Chromium::~Chromium()
{
    close(m_to);
    close(m_from);
    kill(-m_pid, SIGKILL);
    while (waitpid(-m_pid, nullptr, 0) > 0) { } // none is left that could write to the profile
}

void Chromium::send(const nlohmann::json& message)
{
    const std::string text = message.dump();
    std::size_t sent = 0;
    while (sent <= text.size()) { // with the zero byte at its end
        const ssize_t n = write(m_to, text.c_str() + sent, text.size() + 1 - sent);
        if (n < 0)
            throw std::runtime_error("Chromium is gone");
        sent += static_cast<std::size_t>(n);
    }
}

nlohmann::json Chromium::receive(std::chrono::steady_clock::time_point deadline)
{
    std::size_t end;
    while ((end = m_received.find('\0')) == std::string::npos)
        read(deadline);
    nlohmann::json message = nlohmann::json::parse(m_received.substr(0, end));
    m_received.erase(0, end + 1);
    return message;
}

void Chromium::read(std::chrono::steady_clock::time_point deadline)
{
    using namespace std::chrono;
    const auto left = duration_cast<milliseconds>(deadline - steady_clock::now()).count();
    pollfd ready { m_from, POLLIN, 0 };
    if (left <= 0 || poll(&ready, 1, static_cast<int>(left)) <= 0)
        throw std::runtime_error("Chromium did not answer in time");
    std::array<char, 65536> buffer;
    const ssize_t n = ::read(m_from, buffer.data(), buffer.size());
    if (n <= 0)
        throw std::runtime_error("Chromium is gone");
    m_received.append(buffer.data(), static_cast<std::size_t>(n));
}

}
