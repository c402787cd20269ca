#include "gui/false_color_panel.h"
#include "gui/scale.h"
#include <fmt/format.h>
#include <imgui.h>

namespace gui {
namespace {

    using debug::Quantity;

    ImU32 toImGui(const glm::vec3& color)
    {
        return ImGui::GetColorU32({ color.x, color.y, color.z, 1.0f });
    }

    // From the lowest value to the highest, with both below its ends.
    void heatBar(const debug::Range& range)
    {
        constexpr int numSteps = 64; // linear in between
        const glm::vec2 size = glm::vec2(256.0f, 14.0f) * scale();
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float step = size.x / static_cast<float>(numSteps);
        const auto colorAt = [](int i) { return toImGui(debug::heat(static_cast<float>(i) / numSteps)); };
        for (int i = 0; i < numSteps; ++i) {
            const float x = corner.x + step * static_cast<float>(i);
            ImGui::GetWindowDrawList()->AddRectFilledMultiColor({ x, corner.y }, { x + step, corner.y + size.y },
                colorAt(i), colorAt(i + 1), colorAt(i + 1), colorAt(i));
        }
        ImGui::Dummy({ size.x, size.y });
        const std::string highest = fmt::format("{:g}", range.highest);
        ImGui::TextUnformatted(fmt::format("{:g}", range.lowest).c_str());
        ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + size.x - ImGui::CalcTextSize(highest.c_str()).x);
        ImGui::TextUnformatted(highest.c_str());
    }

    const char* channelsOf(Quantity quantity)
    {
        switch (quantity) {
        case Quantity::Normal:
            return "red x, green y, blue z: dark -1, light 1";
        case Quantity::TexCoord:
            return "red u, green v: dark 0, light 1";
        default:
            return "red v0, green v1, blue v2: dark 0, light 1";
        }
    }

    std::optional<glm::vec3> valueUnderMouse(const Picture& picture, glm::vec2 first, glm::vec2 last)
    {
        const ImGuiIO& io = ImGui::GetIO();
        const glm::vec2 place = (glm::vec2(io.MousePos.x, io.MousePos.y) - first) / (last - first);
        if (io.WantCaptureMouse || !(place.x >= 0.0f && place.y >= 0.0f && place.x < 1.0f && place.y < 1.0f))
            return std::nullopt;
        const glm::ivec2 fromTop { place * glm::vec2(picture.size) };
        const int row = picture.size.y - 1 - fromTop.y;
        return picture.values[static_cast<std::size_t>(row * picture.size.x + fromTop.x)];
    }

}

std::optional<Quantity> quantityCombo(Quantity now)
{
    std::optional<Quantity> chosen;
    if (ImGui::BeginCombo("shows", debug::nameOf(now).c_str())) {
        for (const Quantity quantity : debug::allQuantities())
            if (ImGui::Selectable(debug::nameOf(quantity).c_str(), quantity == now))
                chosen = quantity;
        ImGui::EndCombo();
    }
    return chosen;
}

void legend(const Picture& picture, glm::vec2 first, glm::vec2 last)
{
    if (picture.values.empty())
        return;
    constexpr float margin = 10.0f;
    ImGui::SetNextWindowPos({ first.x + margin, last.y - margin }, ImGuiCond_Always, { 0.0f, 1.0f });
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("legend", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs
            | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing
            | ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (debug::isNumber(picture.quantity))
        heatBar(picture.range);
    else
        ImGui::TextUnformatted(channelsOf(picture.quantity));
    const auto value = valueUnderMouse(picture, first, last);
    ImGui::TextUnformatted(
        (value ? debug::describe(picture.quantity, *value) : debug::nameOf(picture.quantity)).c_str());
    ImGui::End();
}

}
