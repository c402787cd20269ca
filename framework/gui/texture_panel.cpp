#include "gui/texture_panel.h"
#include "gui/magnified.h"
#include "gui/scale.h"
#include "gui/texture_space.h"
#include <fmt/format.h>

namespace gui {
namespace {

    constexpr ImU32 outline = IM_COL32(255, 220, 90, 255), black = IM_COL32(0, 0, 0, 255);
    constexpr ImU32 cross = IM_COL32(255, 70, 60, 255);

    std::string describe(const worker::TextureLookup& lookup)
    {
        return fmt::format("bounce {}{}: texture {} at ({:.3g}, {:.3g})", lookup.cause.bounce,
            lookup.cause.way == debug::Way::Shadow ? ", to a light" : "", lookup.texture, lookup.texCoord.x,
            lookup.texCoord.y);
    }

    // Reserves room for a part of texture space in the current window. The longer side takes so many pixels of an
    // ordinary screen.
    Magnified reserve(const glm::vec2& first, const glm::vec2& last, float side)
    {
        const glm::vec2 extent = last - first;
        const float magnification = side * scale() / std::max(extent.x, extent.y);
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ImGui::Dummy({ magnification * extent.x, magnification * extent.y });
        return { { corner.x, corner.y }, first, last, magnification };
    }

    void fill(const Magnified& part, const glm::vec2& first, const glm::vec2& last, const glm::vec3& color)
    {
        ImGui::GetWindowDrawList()->AddRectFilled(at(part, { first.x, last.y }), at(part, { last.x, first.y }),
            ImGui::GetColorU32({ color.x, color.y, color.z, 1.0f }));
    }

    // Seen on any colour.
    void frame(const Magnified& part, const glm::vec2& first, const glm::vec2& last)
    {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 a = at(part, { first.x, last.y }), b = at(part, { last.x, first.y });
        list.AddRect(a, b, black, 0.0f, ImDrawFlags_None, 4.0f * scale());
        list.AddRect(a, b, outline, 0.0f, ImDrawFlags_None, 2.0f * scale());
    }

    // On the side of the texel that is away from the point, which is marked over it.
    void writeWeight(const Magnified& part, const debug::Texel& texel, const glm::vec2& point)
    {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const std::string text = fmt::format("{:.2f}", texel.weight);
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        const glm::vec2 middle = glm::vec2(texel.index) + 0.5f;
        const ImVec2 p = at(part, middle);
        const ImVec2 a { p.x - size.x / 2.0f, point.y < middle.y ? p.y - size.y : p.y };
        list.AddRectFilled(a, { a.x + size.x, a.y + size.y }, IM_COL32(0, 0, 0, 170));
        list.AddText(a, outline, text.c_str());
    }

    void markPoint(const Magnified& part, const glm::vec2& point)
    {
        if (!part.shows(point))
            return;
        const float arm = 5.0f * scale(); // pixels
        const ImVec2 p = at(part, point);
        for (const auto& [color, width] : { std::pair(black, 4.0f), std::pair(cross, 2.0f) }) {
            ImGui::GetWindowDrawList()->AddLine({ p.x - arm, p.y }, { p.x + arm, p.y }, color, width * scale());
            ImGui::GetWindowDrawList()->AddLine({ p.x, p.y - arm }, { p.x, p.y + arm }, color, width * scale());
        }
    }

    void drawTexels(const worker::TextureLookup& lookup, const Image& image, const TexelRange& shown)
    {
        const Magnified part = reserve(shown.first, shown.end, 248.0f);
        const TexelRange whole { glm::ivec2(0), lookup.size };
        const glm::vec2 point = lookup.texCoord * glm::vec2(lookup.size);
        for (int y = shown.first.y; y < shown.end.y; ++y)
            for (int x = shown.first.x; x < shown.end.x; ++x)
                if (const glm::ivec2 texel { x, y }; whole.contains(texel))
                    fill(part, texel, texel + 1, colorOf(image, texel));
        std::size_t numElsewhere = lookup.texels.size();
        for (const debug::Texel& texel : lookup.texels)
            if (shown.contains(texel.index)) {
                frame(part, texel.index, texel.index + 1);
                writeWeight(part, texel, point);
                --numElsewhere;
            }
        markPoint(part, point);
        if (numElsewhere > 0)
            ImGui::Text("%zu more texels took part elsewhere", numElsewhere);
    }

    void drawOverview(const Image& image, const TexelRange& shown)
    {
        const glm::ivec2 size { image.width, image.height }, cells = numCells(size, 64);
        const Magnified whole = reserve(glm::vec2(0.0f), size, 96.0f);
        const glm::vec2 cellSize = glm::vec2(size) / glm::vec2(cells);
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x) {
                const glm::ivec2 cell { x, y };
                const glm::vec3 color = colorOf(image, texelOfCell(cell, cells, size));
                fill(whole, glm::vec2(cell) * cellSize, glm::vec2(cell + 1) * cellSize, color);
            }
        frame(whole, glm::max(shown.first, glm::ivec2(0)), glm::min(shown.end, size));
    }

}

void TexturePanel::choose(const std::vector<worker::TextureLookup>& lookups)
{
    m_lookup = std::min(m_lookup, lookups.size() - 1); // of another ray
    const auto step = [&](const char* name, ImGuiDir direction, std::size_t by) {
        if (ImGui::ArrowButton(name, direction))
            m_lookup = (m_lookup + by) % lookups.size();
        ImGui::SameLine();
    };
    step("previous", ImGuiDir_Left, lookups.size() - 1);
    step("next", ImGuiDir_Right, 1);
    ImGui::Text("lookup %zu of %zu", m_lookup + 1, lookups.size());
    ImGui::TextUnformatted(describe(lookups[m_lookup]).c_str());
}

void TexturePanel::show(const worker::DebugRay& ray, const Scene& scene)
{
    if (ray.lookups.empty())
        return;
    ImGui::SetNextWindowPos({ ImGui::GetIO().DisplaySize.x - 10.0f, 10.0f }, ImGuiCond_FirstUseEver, { 1.0f, 0.0f });
    if (ImGui::Begin("texture space", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        choose(ray.lookups);
        const worker::TextureLookup& lookup = ray.lookups[m_lookup];
        if (const Image* const image = imageOf(lookup, scene.textures)) {
            constexpr int eachWay = 4;
            const TexelRange shown = texelsAround(lookup.texCoord * glm::vec2(lookup.size), lookup.size, eachWay);
            drawTexels(lookup, *image, shown);
            drawOverview(*image, shown);
        } else
            ImGui::TextUnformatted("is not a texture of this scene");
    }
    ImGui::End();
}

}
