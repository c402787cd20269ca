#include "virtual_screen.h"
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tests {

// As a desktop does it: in the resources of the server, from which GLFW takes it.
static void tellDensity(int density)
{
    Display* const display = XOpenDisplay(nullptr);
    if (!display)
        throw std::runtime_error("Xvfb cannot be connected to");
    const std::string resources = "Xft.dpi:\t" + std::to_string(96 * density) + "\n";
    XChangeProperty(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
        reinterpret_cast<const unsigned char*>(resources.data()), static_cast<int>(resources.size()));
    XCloseDisplay(display);
}

// The server picks a free number, and says it once it can be connected to.
VirtualScreen::VirtualScreen(int density)
{
    const std::string size = std::to_string(1280 * density) + "x" + std::to_string(720 * density) + "x24";
    int pipe[2];
    if (::pipe(pipe) != 0)
        throw std::runtime_error("no pipe");
    m_server = fork();
    if (m_server == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        const std::string descriptor = std::to_string(pipe[1]);
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDERR_FILENO);
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", size.c_str(), "-nolisten", "tcp",
            "-noreset", nullptr);
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
    tellDensity(density);
}

VirtualScreen::~VirtualScreen()
{
    kill(m_server, SIGTERM);
    waitpid(m_server, nullptr, 0);
}

}
