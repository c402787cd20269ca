#include "gui/stroke_drawing.h"
#include "gui/scale.h"
#include <glm/common.hpp>

namespace gui {
namespace {

    struct Style {
        float brightness, opacity;
        float width; // pixels of an ordinary screen
        bool isOutlined; // a filled area
    };
    constexpr Style plain { 1.0f, 1.0f, 2.0f, false }, strong { 1.0f, 1.0f, 5.0f, true };
    constexpr Style dimmed { 0.4f, 0.4f, 1.5f, false }; // darker, since many at one place add up to be opaque

    ImU32 packedColorOf(const debug::Stroke& stroke, float brightness, float opacity)
    {
        const glm::vec3 c = brightness * glm::clamp(stroke.color, 0.0f, 1.0f);
        return ImGui::GetColorU32({ c.x, c.y, c.z, opacity });
    }

    void draw(ImDrawList& list, const std::vector<ImVec2>& points, const debug::Stroke& stroke, const Style& style)
    {
        const auto count = static_cast<int>(points.size());
        const float width = style.width * scale();
        const ImU32 color = packedColorOf(stroke, style.brightness, stroke.opacity * style.opacity);
        if (!stroke.isFilled)
            return list.AddPolyline(points.data(), count, color, ImDrawFlags_None, width);
        list.AddConvexPolyFilled(points.data(), count, color);
        if (style.isOutlined)
            list.AddPolyline(points.data(), count, packedColorOf(stroke, style.brightness, style.opacity),
                ImDrawFlags_Closed, width);
    }

}

void drawStrokes(const std::vector<debug::Stroke>& strokes, std::optional<std::size_t> selected, const glm::vec2& first,
    const glm::vec2& last)
{
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({ first.x, first.y }, { last.x, last.y });
    const auto drawAll = [&](bool areSelected, const Style& style) {
        for (const debug::Stroke& stroke : strokes) {
            if ((stroke.shape == selected) != areSelected)
                continue;
            std::vector<ImVec2> points;
            for (const glm::vec2& point : stroke.points)
                points.emplace_back(first.x + point.x, last.y - point.y);
            draw(list, points, stroke, style);
        }
    };
    drawAll(false, selected ? dimmed : plain);
    drawAll(true, strong); // above the others
    list.PopClipRect();
}

}
