#include "gui/samples_panel.h"
#include "gui/magnified.h"
#include "gui/pixel_samples.h"
#include "gui/scale.h"
#include <functional>

namespace gui {
namespace {

    constexpr ImU32 edge = IM_COL32(255, 255, 255, 255), grid = IM_COL32(110, 110, 110, 255);
    constexpr ImU32 inside = IM_COL32(255, 220, 90, 255), outside = IM_COL32(255, 70, 60, 255);

    void drawGrid(ImDrawList& list, const Magnified& pixel, int inRow)
    {
        constexpr float narrowest = 3.0f; // pixels of the window
        if (pixel.scale < narrowest * static_cast<float>(inRow))
            return;
        for (int i = 1; i < inRow; ++i) {
            const float line = static_cast<float>(i) / static_cast<float>(inRow);
            list.AddLine(at(pixel, { line, 0.0f }), at(pixel, { line, 1.0f }), grid);
            list.AddLine(at(pixel, { 0.0f, line }), at(pixel, { 1.0f, line }), grid);
        }
    }

    // One that is far outside is drawn at the border on its side.
    void drawSample(ImDrawList& list, const Magnified& pixel, const glm::vec2& sample)
    {
        if (!glm::any(glm::isnan(sample)))
            list.AddCircleFilled(at(pixel, glm::clamp(sample, pixel.first, pixel.last)), 3.0f * scale(),
                isInPixel(sample) ? inside : outside);
    }

    void drawPixel(const std::vector<glm::vec2>& samples, const Features& features)
    {
        constexpr std::size_t most = 4096; // that a picture of this size can tell apart
        constexpr float margin = 0.25f; // for those outside, in pixels of the picture
        const float side = 180.0f * scale();
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const Magnified pixel { { corner.x, corner.y }, glm::vec2(-margin), glm::vec2(1.0f + margin),
            side / (1.0f + 2.0f * margin) };
        ImGui::Dummy({ side, side });
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (const auto inRow = cellsInRow(features))
            drawGrid(list, pixel, *inRow);
        list.AddRect(at(pixel, { 0.0f, 1.0f }), at(pixel, { 1.0f, 0.0f }), edge);
        for (std::size_t i = 0; i < std::min(samples.size(), most); ++i)
            drawSample(list, pixel, samples[i]);
        if (samples.size() > most)
            ImGui::Text("the first %zu are shown", most);
    }

}

void samplesPanel(const worker::DebugRay& ray, const Features& features, glm::vec2 corner)
{
    if (ray.samples.empty())
        return;
    ImGui::SetNextWindowPos({ corner.x - 10.0f, corner.y - 10.0f }, ImGuiCond_FirstUseEver, { 1.0f, 1.0f });
    if (ImGui::Begin("pixel", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        const auto numOutside = std::ranges::count_if(ray.samples, std::not_fn(isInPixel));
        ImGui::Text("%d, %d: %zu %s", ray.pixel.x, ray.pixel.y, ray.samples.size(),
            ray.samples.size() == 1 ? "sample" : "samples");
        if (numOutside > 0)
            ImGui::TextColored(ImColor(outside), "%td of them outside", numOutside);
        ImGui::Spacing();
        drawPixel(ray.samples, features);
    }
    ImGui::End();
}

}
