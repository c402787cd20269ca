#pragma once
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

struct GLFWwindow;

namespace gui {

// The window system, or OpenGL, is not to be had.
class NoWindow : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// What happened to a window and nobody has asked for yet.
struct Events {
    std::optional<std::filesystem::path> dropped;
    std::vector<std::string> keys;
};

// A window with an OpenGL 3.3 context and Dear ImGui in it. One at a time.
class Window {
public:
    // The size is of an ordinary screen: on a denser one it has more pixels. The layout is the file where the places
    // and sizes of panels are remembered, if there is one. Throws NoWindow.
    Window(const std::string& title, glm::ivec2 size, std::string layout = "");
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] bool shouldClose() const;

    // What is asked for between the first two is drawn by the second, and appears by the third.
    void beginFrame();
    void drawFrame();
    void showFrame();

    // The file that was dropped on it last, once.
    [[nodiscard]] std::optional<std::filesystem::path> takeDropped();

    // The keys that were pressed since the last call, be they let go again or not: by what is on them on this keyboard,
    // "ctrl+" before it if that was held, "escape", and "?" wherever that is.
    [[nodiscard]] std::vector<std::string> takeKeys();

    [[nodiscard]] glm::ivec2 size() const; // of what can be drawn on, in pixels
    [[nodiscard]] GLFWwindow* handle() const { return m_window; }

private:
    std::string m_layout;
    GLFWwindow* m_window = nullptr;
    double m_lastFrame = 0.0; // when it began, in seconds
    Events m_events;
};

}
