#include "gui/panels.h"
#include <imgui.h>
#include <optional>

namespace gui {
namespace {

    void editPlace(const char* name, glm::vec3& place)
    {
        ImGui::DragFloat3(name, &place.x, 0.01f);
    }

    void editColor(const char* name, glm::vec3& color)
    {
        ImGui::ColorEdit3(name, &color.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR);
    }

    void edit(PointLight& light)
    {
        editPlace("position", light.position);
        editColor("color", light.color);
    }

    void edit(SegmentLight& light)
    {
        editPlace("endpoint0", light.endpoint0);
        editPlace("endpoint1", light.endpoint1);
        editColor("color0", light.color0);
        editColor("color1", light.color1);
    }

    void edit(ParallelogramLight& light)
    {
        editPlace("v0", light.v0);
        editPlace("edge01", light.edge01);
        editPlace("edge02", light.edge02);
        editColor("color0", light.color0);
        editColor("color1", light.color1);
        editColor("color2", light.color2);
        editColor("color3", light.color3);
    }

    constexpr const char* kinds[] { "point", "segment", "parallelogram" }; // in the order of SceneLight

    void addLights(std::vector<Scene::SceneLight>& lights)
    {
        const glm::vec3 white { 1.0f };
        if (ImGui::Button("add point"))
            lights.emplace_back(PointLight { { 0, 1, 0 }, white });
        ImGui::SameLine();
        if (ImGui::Button("add segment"))
            lights.emplace_back(SegmentLight { { -0.5f, 1, 0 }, { 0.5f, 1, 0 }, white, white });
        ImGui::SameLine();
        if (ImGui::Button("add parallelogram"))
            lights.emplace_back(
                ParallelogramLight { { -0.5f, 1, -0.5f }, { 1, 0, 0 }, { 0, 0, 1 }, white, white, white, white });
    }

}

void lightsPanel(std::vector<Scene::SceneLight>& lights)
{
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::Text("light %zu: %s", i + 1, kinds[lights[i].index()]);
        ImGui::SameLine();
        if (ImGui::SmallButton("remove"))
            removed = i;
        std::visit([](auto& light) { edit(light); }, lights[i]);
        ImGui::PopID();
    }
    if (removed)
        lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(*removed));
    addLights(lights);
}

}
