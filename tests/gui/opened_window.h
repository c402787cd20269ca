#pragma once
#include "control.h"
#include "gui/application.h"
#include "gui/window.h"
#include "virtual_screen.h"
#include <functional>

namespace tests {

// The window that a student opens, on a screen of its own.
class OpenedWindow {
public:
    // Density: pixels for one of an ordinary screen. Layout: the file that remembers it; usually none, so that no test
    // sees another's.
    OpenedWindow(const std::filesystem::path& scene, const std::filesystem::path& submission, int density = 1,
        const std::string& layout = "");

    // Draws frames until it is so; fails the test if that takes longer than anything should.
    void drawUntil(const std::function<bool()>& isSo);
    void drawUntilTraced();
    void drawFrames(int count);

    // What a user does. Pixels from the top left; buttons from 1, left to right; keys as X calls them, such as ctrl+z.
    void moveMouse(glm::ivec2 position);
    void dragMouse(glm::ivec2 from, glm::ivec2 to, int button = 1);
    void pressKey(const std::string& key);
    void tapKey(const std::string& key); // down and up between two frames

    void drop(const std::filesystem::path& file);

    // These work on controls that are in sight.
    void activate(const Control& control);
    void enter(const Control& field, const std::string& text);
    void choose(const Control& combo, const std::string& item);

    // Opens this section of the side panel and closes the others, so that it is in sight.
    void showOnly(const std::string& section);
    [[nodiscard]] bool isOpen(const std::string& section) const;

    // What is on the screen, row 0 at the bottom.
    [[nodiscard]] gui::Picture screenshot();

    // The camera that the picture is seen from, and where the window shows a place of it, in pixels from its bottom
    // left.
    [[nodiscard]] Trackball camera() const;
    [[nodiscard]] glm::ivec2 toWindow(const glm::vec2& place);

private:
    VirtualScreen m_screen;
    gui::Window m_window;

public:
    gui::Application application;
};

}
