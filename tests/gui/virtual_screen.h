#pragma once
#include <sys/types.h>

namespace tests {

// A screen that nobody sees, for as long as it lives: an X server of its own, which DISPLAY names. It tells programs
// how dense it is, in pixels for one of an ordinary screen. Throws std::runtime_error when there is none to be had.
class VirtualScreen {
public:
    explicit VirtualScreen(int density = 1);
    ~VirtualScreen();
    VirtualScreen(const VirtualScreen&) = delete;
    VirtualScreen& operator=(const VirtualScreen&) = delete;

private:
    pid_t m_server = -1;
};

}
