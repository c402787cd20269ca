#include "gui/profiler_strip.h"
#include "values/resident_memory.h"
#include <imgui.h>

namespace gui {
namespace {

    void rays(const Picture& picture)
    {
        const auto perSecond
            = [&](uint64_t count) { return 1e-6 * static_cast<double>(count) / std::max(picture.seconds, 1e-9); };
        const accel::RayCounts& counts = picture.work.rays;
        ImGui::Text("million rays a second: %.2f camera, %.2f bounced, %.2f shadow (%.2f left out) in %.2f s",
            perSecond(counts.camera), perSecond(counts.bounced), perSecond(counts.shadow), perSecond(counts.leftOut()),
            picture.seconds);
    }

    void memory(const char* whose, std::size_t bytes)
    {
        if (bytes > 0)
            ImGui::Text("%s %.0f MB", whose, 1e-6 * static_cast<double>(bytes));
        else
            ImGui::Text("%s ? MB", whose);
    }

    void nextColumn(float x)
    {
        ImGui::SameLine(x * ImGui::GetFontSize());
    }

}

float ProfilerStrip::height()
{
    return ImGui::GetFrameHeight() + 2.0f * ImGui::GetStyle().WindowPadding.y;
}

void ProfilerStrip::show(const Picture& picture, glm::vec2 first, glm::vec2 last)
{
    ImGui::SetNextWindowPos({ first.x, first.y });
    ImGui::SetNextWindowSize({ last.x - first.x, last.y - first.y });
    ImGui::Begin("profiler", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings
            | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::AlignTextToFramePadding();
    rays(picture);
    nextColumn(50.0f);
    frames();
    nextColumn(73.0f);
    memory("the code", picture.memory);
    ImGui::SameLine();
    memory("the window", values::residentMemory());
    ImGui::SameLine();
    ImGui::Checkbox("count", &isCounting);
    ImGui::End();
}

void ProfilerStrip::frames()
{
    const float milliseconds = 1000.0f * ImGui::GetIO().DeltaTime;
    m_milliseconds[m_next] = milliseconds;
    m_next = (m_next + 1) % m_milliseconds.size();
    constexpr float slowest = 50.0f; // milliseconds: twenty frames a second fill the height
    ImGui::Text("%5.1f ms a frame", static_cast<double>(milliseconds));
    ImGui::SameLine();
    ImGui::PlotLines("##frames", m_milliseconds.data(), static_cast<int>(m_milliseconds.size()),
        static_cast<int>(m_next), nullptr, 0.0f, slowest, { 10.0f * ImGui::GetFontSize(), ImGui::GetFrameHeight() });
}

}
