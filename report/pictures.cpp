#include "report/pictures.h"
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace report {
namespace {

    const glm::vec3& pixelAt(const Picture& picture, glm::ivec2 at)
    {
        return picture.pixels.at(
            static_cast<std::size_t>(at.y) * static_cast<std::size_t>(picture.size.x) + static_cast<std::size_t>(at.x));
    }

    template <typename ColorAt> Picture paint(std::string label, glm::ivec2 size, const ColorAt& colorAt)
    {
        Picture picture { std::move(label), size, {} };
        picture.pixels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                picture.pixels.push_back(colorAt(glm::ivec2(x, y)));
        return picture;
    }

    void expectOneSize(const Picture& a, const Picture& b)
    {
        if (a.size != b.size || a.pixels.size() != b.pixels.size())
            throw std::invalid_argument("pictures of different sizes: " + a.label + ", " + b.label);
    }

}

Picture magnified(const Picture& picture, int factor)
{
    return paint(picture.label, picture.size * factor, [&](glm::ivec2 at) { return pixelAt(picture, at / factor); });
}

Picture crop(const Picture& picture, glm::ivec2 from, glm::ivec2 size)
{
    return paint(picture.label, size, [&](glm::ivec2 at) { return pixelAt(picture, from + at); });
}

Picture difference(std::string label, const Picture& a, const Picture& b, float gain)
{
    expectOneSize(a, b);
    return paint(
        std::move(label), a.size, [&](glm::ivec2 at) { return gain * glm::abs(pixelAt(a, at) - pixelAt(b, at)); });
}

double rmse(const Picture& a, const Picture& b)
{
    expectOneSize(a, b);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::dvec3 gap = glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]);
        sum += glm::dot(gap, gap);
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

Fact errorAgainst(const Picture& reference, const Picture& picture)
{
    return { "RMSE against " + reference.label, fmt::format("{:.2g}", rmse(reference, picture)) };
}

}
