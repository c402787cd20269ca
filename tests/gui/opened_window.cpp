#include "opened_window.h"
#include <GL/gl.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace tests {

OpenedWindow::OpenedWindow(const std::filesystem::path& scene, const std::filesystem::path& submission)
    : m_window("test", { 1280, 720 })
    , application(scene, submission)
{
    ImGui::GetIO().IniFilename = nullptr; // no test sees another's layout
    moveMouse({ 1, 1 });
}

void OpenedWindow::drawFrames(int count)
{
    for (int i = 0; i < count; ++i) {
        m_window.beginFrame();
        application.frame(m_window.size());
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
    send(fmt::format("mousemove --sync {} {}", position.x, position.y));
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

void OpenedWindow::activate(const char* label, int place)
{
    const ImGuiWindow* const side = ImGui::FindWindowByName("side");
    REQUIRE(side);
    const ImGuiID list = place < 0 ? side->ID : ImHashData(&place, sizeof(place), side->ID);
    ImGui::ActivateItem(ImHashStr(label, 0, list));
    drawFrames(3); // it is pressed in the next, and what follows from it is shown after that
}

void OpenedWindow::choose(const char* combo, const char* item)
{
    activate(combo);
    const ImGuiWindow* const list = ImGui::FindWindowByName("##Combo_00");
    REQUIRE(list);
    REQUIRE(list->Active);
    ImGui::ActivateItem(ImHashStr(item, 0, list->ID));
    drawFrames(3);
}

gui::Picture OpenedWindow::screenshot()
{
    gui::Picture picture;
    picture.size = m_window.size();
    picture.pixels.resize(static_cast<std::size_t>(picture.size.x * picture.size.y));
    m_window.beginFrame();
    application.frame(m_window.size());
    m_window.drawFrame();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, picture.size.x, picture.size.y, GL_RGB, GL_FLOAT, picture.pixels.data());
    m_window.showFrame();
    return picture;
}

}
