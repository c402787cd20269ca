#include "gui/save_panel.h"
#include "files/bitmap.h"
#include "files/camera_file.h"
#include "files/error.h"
#include "files/scene_writer.h"
#include "files/text.h"
#include <array>
#include <fmt/format.h>
#include <imgui.h>

namespace gui {

void SavePanel::show(Document& document, const Picture& picture, glm::ivec2 area)
{
    std::array<char, 1024> name {};
    m_name.copy(name.data(), name.size() - 1);
    if (ImGui::InputText("name", name.data(), name.size()))
        m_name = name.data();
    if (ImGui::Button("save scene"))
        saveScene(document, area);
    ImGui::SameLine();
    if (ImGui::Button("save picture") && !picture.pixels.empty())
        savePicture(picture);
    cameraButtons(document.settings.config.camera);
    if (!m_outcome.empty())
        ImGui::TextWrapped("%s", m_outcome.c_str());
}

// Files of their own, so that a scene of the same name stays.
void SavePanel::cameraButtons(CameraConfig& camera)
{
    constexpr const char* extension = ".camera.toml";
    if (ImGui::Button("save camera"))
        attempt("saved", extension, [&](const auto& path) { files::saveCamera(path, camera); });
    ImGui::SameLine();
    if (ImGui::Button("load camera"))
        attempt("loaded", extension, [&](const auto& path) { camera = files::loadCamera(path); });
}

template <typename Action> void SavePanel::attempt(const char* done, const std::string& extension, const Action& action)
{
    const std::filesystem::path path = std::filesystem::absolute(m_name + extension);
    try {
        action(path);
        m_outcome = fmt::format("{} {}", done, path.string());
    } catch (const files::Error& error) {
        m_outcome = error.what();
    }
}

void SavePanel::saveScene(const Document& document, glm::ivec2 area)
{
    Config config = document.settings.config;
    config.size = area;
    attempt("saved", ".toml", [&](const std::filesystem::path& path) {
        files::saveScene(path, document.path(), config, document.settings.lights);
    });
}

void SavePanel::savePicture(const Picture& picture)
{
    attempt("saved", ".png", [&](const std::filesystem::path& path) {
        const std::vector<std::byte> png = files::encodePng(picture.size, picture.pixels);
        files::writeText(path, { reinterpret_cast<const char*>(png.data()), png.size() });
    });
}

}
