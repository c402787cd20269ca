#include "shapes/shapes.h"
#include "shapes/makers.h"
#include <algorithm>
#include <array>

namespace shapes {
namespace {

    struct NamedShape {
        std::string_view name;
        Mesh (*make)();
    };

    constexpr std::array namedShapes {
        NamedShape { "triangle", makeTriangle },
        NamedShape { "cube", makeCube },
        NamedShape { "monkey", makeMonkey },
        NamedShape { "teapot", makeTeapot },
        NamedShape { "dragon", makeDragon },
    };

}

std::optional<Mesh> makeShape(std::string_view name)
{
    const auto shape = std::ranges::find(namedShapes, name, &NamedShape::name);
    return shape == namedShapes.end() ? std::nullopt : std::optional(shape->make());
}

std::vector<std::string_view> shapeNames()
{
    std::vector<std::string_view> names;
    std::ranges::transform(namedShapes, std::back_inserter(names), &NamedShape::name);
    return names;
}

}
