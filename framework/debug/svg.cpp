#include "debug/svg.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sodium.h>

namespace debug {
namespace {

    std::string toBase64(std::span<const std::byte> bytes)
    {
        constexpr int variant = sodium_base64_VARIANT_ORIGINAL;
        std::string text(sodium_base64_encoded_len(bytes.size(), variant), '\0');
        sodium_bin2base64(
            text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), variant);
        text.pop_back(); // the terminating zero
        return text;
    }

    std::string toHex(const glm::vec3& color)
    {
        const auto channel = [](float value) { return std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f); };
        return fmt::format("#{:02x}{:02x}{:02x}", channel(color.x), channel(color.y), channel(color.z));
    }

    // There y runs down.
    std::string pointsOf(const Stroke& stroke, int height)
    {
        std::string text;
        for (const glm::vec2& point : stroke.points)
            text += fmt::format("{:.2f},{:.2f} ", point.x, static_cast<float>(height) - point.y);
        text.pop_back();
        return text;
    }

    std::string toElement(const Stroke& stroke, int height)
    {
        const std::string color = toHex(stroke.color);
        const std::string paint = stroke.isFilled
            ? fmt::format("fill=\"{}\" fill-opacity=\"{:.3g}\"", color, stroke.opacity)
            : fmt::format("stroke=\"{}\" stroke-opacity=\"{:.3g}\"", color, stroke.opacity);
        return fmt::format("<{} data-shape=\"{}\" points=\"{}\" {}/>\n", stroke.isFilled ? "polygon" : "polyline",
            stroke.shape, pointsOf(stroke, height), paint);
    }

}

std::string toSvg(const std::vector<Stroke>& strokes, glm::ivec2 size, std::span<const std::byte> background)
{
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
        "<image width=\"{0}\" height=\"{1}\" href=\"data:image/png;base64,{2}\"/>\n"
        "<g fill=\"none\" stroke-width=\"2\" stroke-linecap=\"round\">\n",
        size.x, size.y, toBase64(background));
    for (const Stroke& stroke : strokes)
        svg += toElement(stroke, size.y);
    return svg + "</g>\n</svg>\n";
}

}
