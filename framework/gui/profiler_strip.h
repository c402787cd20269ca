#pragma once
#include "gui/exchange.h"
#include <array>

namespace gui {

// What it costs, in a line along the bottom of the window: rays a second by kind, time per frame, memory.
class ProfilerStrip {
public:
    // In pixels.
    [[nodiscard]] static float height();

    // Between these corners of the window.
    void show(const Picture& picture, glm::vec2 first, glm::vec2 last);

    bool isCounting = false; // the user wants to know more of the work than the rays, though that is slower

private:
    void frames();

    std::array<float, 120> m_milliseconds {}; // of the last frames
    std::size_t m_next = 0; // the oldest of them
};

}
