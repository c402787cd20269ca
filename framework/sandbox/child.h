#pragma once
#include "sandbox/command.h"
#include "sandbox/file.h"
#include <chrono>
#include <sys/types.h>

namespace sandbox {

using Clock = std::chrono::steady_clock;

// A running command and all that it starts: gone when this goes, and before kill() returns.
class Child {
public:
    // Locked in by Bubblewrap where that works (see whyNoBubblewrap), with limits and a filter of system calls in any
    // case. Throws std::system_error when it cannot be started.
    explicit Child(const Command& command);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    // How a command ended.
    struct End {
        int exitCode = -1; // if it ended by itself
        int signal = 0; // if it did not
    };

    // Whether it has ended, by itself, before the deadline.
    [[nodiscard]] bool hasEndedBy(Clock::time_point deadline) const;
    // Kills what is left of it, and tells how it ended.
    End kill();

private:
    pid_t m_pid = -1; // the command's, or that of the Bubblewrap around it
    File m_first; // pidfd of the first process in the sandbox: with it, all others end
    End m_end;
};

}
