#include "gui/window.h"
#include "gui/scale.h"
#define GLFW_INCLUDE_NONE
#include <GL/gl.h>
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <cmath>
#include <imgui.h>
#include <utility>

namespace gui {
namespace {

    std::string lastError()
    {
        const char* text = nullptr;
        glfwGetError(&text);
        return text ? text : "no reason is given";
    }

    Events& eventsOf(GLFWwindow* window)
    {
        return *static_cast<Events*>(glfwGetWindowUserPointer(window));
    }

    void onDrop(GLFWwindow* window, int count, const char** paths)
    {
        if (count > 0)
            eventsOf(window).dropped = paths[count - 1];
    }

    void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers)
    {
        if (action != GLFW_PRESS) // one that is held is pressed once
            return;
        const char* const name = key == GLFW_KEY_ESCAPE ? "escape" : glfwGetKeyName(key, scancode);
        if (name)
            eventsOf(window).keys.push_back((modifiers & GLFW_MOD_CONTROL ? "ctrl+" : "") + std::string(name));
    }

    // A sign is made by different keys on different keyboards.
    void onCharacter(GLFWwindow* window, unsigned character)
    {
        if (character == '?')
            eventsOf(window).keys.emplace_back("?");
    }

    // So that text is read as easily on a dense screen.
    void scaleTo(GLFWwindow* window)
    {
        float scale = 1.0f;
        glfwGetWindowContentScale(window, &scale, nullptr);
        ImGui::GetStyle().ScaleAllSizes(scale);
        ImFontConfig font;
        font.SizePixels = std::round(plainFontSize * scale);
        ImGui::GetIO().Fonts->AddFontDefault(&font);
    }

}

Window::Window(const std::string& title, glm::ivec2 size, std::string layout)
    : m_layout(std::move(layout))
{
    if (!glfwInit())
        throw NoWindow("there is no window system to open a window on: " + lastError());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    m_window = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (!m_window) {
        const std::string error = lastError();
        glfwTerminate();
        throw NoWindow("no window with OpenGL 3.3 can be opened: " + error);
    }
    glfwMakeContextCurrent(m_window);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(m_window, &m_events);
    glfwSetDropCallback(m_window, onDrop);
    glfwSetKeyCallback(m_window, onKey); // ImGui, which comes later, calls these two as well
    glfwSetCharCallback(m_window, onCharacter);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = m_layout.empty() ? nullptr : m_layout.c_str();
    ImGui_ImplGlfw_InitForOpenGL(m_window, true);
    ImGui_ImplOpenGL3_Init("#version 330");
    scaleTo(m_window);
}

Window::~Window()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(m_window);
    glfwTerminate();
}

bool Window::shouldClose() const
{
    return glfwWindowShouldClose(m_window) != 0;
}

void Window::beginFrame()
{
    constexpr double interval = 1.0 / 60.0; // seconds: what the tracer sends is shown that soon
    const double left = m_lastFrame + interval - glfwGetTime();
    if (left > 0.0)
        glfwWaitEventsTimeout(left);
    else
        glfwPollEvents();
    m_lastFrame = glfwGetTime();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Window::drawFrame()
{
    ImGui::Render();
    const glm::ivec2 pixels = size();
    glViewport(0, 0, pixels.x, pixels.y);
    glClearColor(0.1f, 0.1f, 0.1f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::showFrame()
{
    glfwSwapBuffers(m_window);
}

std::optional<std::filesystem::path> Window::takeDropped()
{
    return std::exchange(m_events.dropped, std::nullopt);
}

std::vector<std::string> Window::takeKeys()
{
    return std::exchange(m_events.keys, {});
}

glm::ivec2 Window::size() const
{
    glm::ivec2 pixels { 0 };
    glfwGetFramebufferSize(m_window, &pixels.x, &pixels.y);
    return pixels;
}

}
