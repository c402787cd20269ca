#pragma once
#include <sys/types.h>

namespace tests {

// A screen that nobody sees, for as long as it lives: an X server of its own, which DISPLAY names. Throws
// std::runtime_error when there is none to be had.
class VirtualScreen {
public:
    VirtualScreen();
    ~VirtualScreen();
    VirtualScreen(const VirtualScreen&) = delete;
    VirtualScreen& operator=(const VirtualScreen&) = delete;

private:
    pid_t m_server = -1;
};

}
