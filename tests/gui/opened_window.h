#pragma once
#include "gui/application.h"
#include "gui/window.h"
#include "virtual_screen.h"
#include <functional>

namespace tests {

// The window that a student opens, on a screen of its own.
class OpenedWindow {
public:
    OpenedWindow(const std::filesystem::path& scene, const std::filesystem::path& submission);

    // Draws frames until it is so; fails the test if that takes longer than anything should.
    void drawUntil(const std::function<bool()>& isSo);
    void drawUntilTraced();
    void drawFrames(int count);

    // What a user does. Pixels from the top left; buttons from 1, left to right; keys as X calls them, such as ctrl+z.
    void moveMouse(glm::ivec2 position);
    void dragMouse(glm::ivec2 from, glm::ivec2 to, int button = 1);
    void pressKey(const std::string& key);

    // A control of the side panel, by its label and, in a list, by its place.
    void activate(const char* label, int place = -1);

    // One of the items that a control of the side panel unfolds.
    void choose(const char* combo, const char* item);

    // What is on the screen, row 0 at the bottom.
    [[nodiscard]] gui::Picture screenshot();

private:
    VirtualScreen m_screen;
    gui::Window m_window;

public:
    gui::Application application;
};

}
