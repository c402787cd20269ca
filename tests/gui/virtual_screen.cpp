#include "virtual_screen.h"
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tests {

// The server picks a free number, and says it once it can be connected to.
VirtualScreen::VirtualScreen()
{
    int pipe[2];
    if (::pipe(pipe) != 0)
        throw std::runtime_error("no pipe");
    m_server = fork();
    if (m_server == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        const std::string descriptor = std::to_string(pipe[1]);
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDERR_FILENO);
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1280x720x24", "-nolisten", "tcp",
            nullptr);
        _exit(127);
    }
    close(pipe[1]);
    std::string number;
    for (char c = 0; read(pipe[0], &c, 1) == 1 && c != '\n';)
        number += c;
    close(pipe[0]);
    if (number.empty())
        throw std::runtime_error("Xvfb does not start");
    setenv("DISPLAY", (":" + number).c_str(), 1);
}

VirtualScreen::~VirtualScreen()
{
    kill(m_server, SIGTERM);
    waitpid(m_server, nullptr, 0);
}

}
