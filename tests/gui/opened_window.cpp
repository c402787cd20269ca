#include "opened_window.h"
#define GLFW_INCLUDE_NONE
#include <GL/gl.h>
#include <GLFW/glfw3.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace tests {

OpenedWindow::OpenedWindow(
    const std::filesystem::path& scene, const std::filesystem::path& submission, int density, const std::string& layout)
    : m_screen(density)
    , m_window("test", { 1280, 720 }, layout)
    , application(scene, submission)
{
    moveMouse({ 1, 1 });
}

void OpenedWindow::drawFrames(int count)
{
    for (int i = 0; i < count; ++i) {
        m_window.beginFrame();
        application.frame(m_window);
        m_window.drawFrame();
        m_window.showFrame();
    }
}

void OpenedWindow::drawUntil(const std::function<bool()>& isSo)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    drawFrames(1);
    while (!isSo()) {
        drawFrames(1);
        if (std::chrono::steady_clock::now() > end)
            FAIL("waited in vain; the window says: " << application.message());
    }
}

void OpenedWindow::drawUntilTraced()
{
    drawUntil([&] { return application.isPictureDone(); });
}

// Through the X server, like any user's.
static void send(const std::string& input)
{
    INFO(input);
    REQUIRE(std::system(("xdotool " + input).c_str()) == 0);
}

void OpenedWindow::moveMouse(glm::ivec2 position)
{
    send(fmt::format("mousemove {} {}", position.x, position.y));
    drawUntil([&] {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        return glm::ivec2(mouse.x, mouse.y) == position;
    });
}

void OpenedWindow::dragMouse(glm::ivec2 from, glm::ivec2 to, int button)
{
    const auto isDown = [&] { return ImGui::IsAnyMouseDown(); };
    moveMouse(from);
    send(fmt::format("mousedown {}", button));
    drawUntil(isDown);
    drawFrames(2);
    moveMouse(to);
    drawFrames(2);
    send(fmt::format("mouseup {}", button));
    drawUntil([&] { return !isDown(); });
}

void OpenedWindow::pressKey(const std::string& key)
{
    const auto isAnyDown = [] { return std::ranges::count(ImGui::GetIO().KeysDown, true) > 0; };
    send("keydown " + key);
    drawUntil(isAnyDown);
    drawFrames(1);
    send("keyup " + key);
    drawUntil([&] { return !isAnyDown(); });
}

void OpenedWindow::tapKey(const std::string& key)
{
    send("key " + key);
}

// By the window's own callback, which nobody but GLFW is given otherwise.
void OpenedWindow::drop(const std::filesystem::path& file)
{
    const GLFWdropfun onDrop = glfwSetDropCallback(m_window.handle(), nullptr);
    glfwSetDropCallback(m_window.handle(), onDrop);
    REQUIRE(onDrop);
    const std::string path = file.string();
    const char* const paths[] { path.c_str() };
    onDrop(m_window.handle(), 1, const_cast<const char**>(paths));
    drawFrames(2);
}

ImGuiWindow* Control::window() const
{
    ImGuiWindow* const window = ImGui::FindWindowByName(panel.c_str());
    INFO(panel);
    REQUIRE(window);
    return window;
}

ImGuiID Control::id() const
{
    ImGuiID id = window()->ID;
    for (const auto& step : path)
        if (const auto* const label = std::get_if<std::string>(&step))
            id = ImHashStr(label->c_str(), 0, id);
        else
            id = ImHashData(&std::get<int>(step), sizeof(int), id);
    return id;
}

void OpenedWindow::activate(const Control& control)
{
    // As if the keyboard had led there: a control that is scrolled out of sight takes part in the frame then. ImGui
    // wants the window as well, and there is none after a click on the picture.
    ImGui::FocusWindow(control.window());
    GImGui->NavId = control.id();
    ImGui::ActivateItem(control.id());
    drawFrames(3); // it is pressed in the next, and what follows from it is shown after that
}

// The letters go where GLFW's go: which keys make them is the keyboard's affair.
void OpenedWindow::enter(const Control& field, const std::string& text)
{
    ImGui::ActivateItem(field.id());
    GImGui->NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
    drawFrames(2);
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    pressKey("Return");
    drawFrames(2);
}

void OpenedWindow::choose(const Control& combo, const std::string& item)
{
    activate(combo);
    const Control inList { { item }, "##Combo_00" };
    ImGuiWindow* const list = ImGui::FindWindowByName("##Combo_00");
    for (float y = 0.0f; list->Active && y <= list->ScrollMax.y + list->Size.y; y += list->Size.y / 2.0f) {
        ImGui::SetScrollY(list, y);
        drawFrames(2);
        activate(inList);
    }
    REQUIRE_FALSE(list->Active); // it closes with the choice
}

bool OpenedWindow::isOpen(const std::string& section) const
{
    return ImGui::FindWindowByName("side")->StateStorage.GetBool(Control(section).id());
}

void OpenedWindow::showOnly(const std::string& section)
{
    ImGuiWindow* const side = ImGui::FindWindowByName("side");
    for (const char* const name : { "scene", "save", "features", "camera", "lights", "output", "tree", "ray" })
        side->StateStorage.SetInt(Control(name).id(), name == section);
    drawFrames(2);
}

gui::Picture OpenedWindow::screenshot()
{
    gui::Picture picture;
    picture.size = m_window.size();
    picture.pixels.resize(static_cast<std::size_t>(picture.size.x * picture.size.y));
    m_window.beginFrame();
    application.frame(m_window);
    m_window.drawFrame();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, picture.size.x, picture.size.y, GL_RGB, GL_FLOAT, picture.pixels.data());
    m_window.showFrame();
    return picture;
}

Trackball OpenedWindow::camera() const
{
    Config config = application.document().settings.config;
    config.size = application.picture().size;
    return makeTrackball(config);
}

// The picture is at the top right.
glm::ivec2 OpenedWindow::toWindow(const glm::vec2& place)
{
    const glm::ivec2 picture = application.picture().size;
    return { m_window.size().x - picture.x + static_cast<int>(place.x), picture.y - static_cast<int>(place.y) };
}

}
