#include "gui/save_panel.h"
#include "files/bitmap.h"
#include "files/error.h"
#include "files/scene_writer.h"
#include "files/text.h"
#include <array>
#include <imgui.h>

namespace gui {

void SavePanel::show(const Document& document, const Picture& picture, glm::ivec2 area)
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
    if (!m_outcome.empty())
        ImGui::TextWrapped("%s", m_outcome.c_str());
}

template <typename Save> void SavePanel::trySaving(const std::string& extension, const Save& save)
{
    const std::filesystem::path path = std::filesystem::absolute(m_name + extension);
    try {
        save(path);
        m_outcome = "saved " + path.string();
    } catch (const files::Error& error) {
        m_outcome = error.what();
    }
}

void SavePanel::saveScene(const Document& document, glm::ivec2 area)
{
    Config config = document.settings.config;
    config.size = area;
    trySaving(".toml", [&](const std::filesystem::path& path) {
        files::saveScene(path, document.path(), config, document.settings.lights);
    });
}

void SavePanel::savePicture(const Picture& picture)
{
    trySaving(".png", [&](const std::filesystem::path& path) {
        const std::vector<std::byte> png = files::encodePng(picture.size, picture.pixels);
        files::writeText(path, { reinterpret_cast<const char*>(png.data()), png.size() });
    });
}

}
