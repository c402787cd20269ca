#include "debug/quantity.h"
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ranges>
#include <stdexcept>

namespace debug {
namespace {

    struct Description {
        const char* name;
        int numComponents;
    };

    // In the order of the enumeration.
    constexpr std::array<Description, 9> descriptions { {
        { "color", 3 },
        { "normal", 3 },
        { "tex_coord", 2 },
        { "barycentric", 3 },
        { "nodes_visited", 1 },
        { "triangles_tested", 1 },
        { "samples", 1 },
        { "rays", 1 },
        { "t", 1 },
    } };
    static_assert(static_cast<std::size_t>(Quantity::Distance) + 1 == descriptions.size());

    const Description& descriptionOf(Quantity quantity)
    {
        return descriptions.at(static_cast<std::size_t>(quantity));
    }

}

std::vector<Quantity> allQuantities()
{
    std::vector<Quantity> all;
    for (std::size_t i = 0; i < descriptions.size(); ++i)
        all.push_back(static_cast<Quantity>(i));
    return all;
}

Quantity nextOf(Quantity quantity)
{
    return static_cast<Quantity>((static_cast<std::size_t>(quantity) + 1) % descriptions.size());
}

std::string nameOf(Quantity quantity)
{
    return descriptionOf(quantity).name;
}

std::string quantityNames()
{
    return fmt::format("{}", fmt::join(descriptions | std::views::transform(&Description::name), ", "));
}

Quantity quantityOf(const std::string& name)
{
    for (const Quantity quantity : allQuantities())
        if (nameOf(quantity) == name)
            return quantity;
    throw std::invalid_argument(fmt::format("found the quantity '{}', expected one of {}", name, quantityNames()));
}

bool isNumber(Quantity quantity)
{
    return descriptionOf(quantity).numComponents == 1;
}

std::string describe(Quantity quantity, const glm::vec3& value)
{
    if (value == nothing)
        return "nothing there";
    const auto& [name, numComponents] = descriptionOf(quantity);
    if (numComponents == 1)
        return fmt::format("{} {:g}", name, value.x); // six digits: counts are told to the last one
    const std::string z = numComponents == 3 ? fmt::format(", {:.3g}", value.z) : "";
    return fmt::format("{} ({:.3g}, {:.3g}{})", name, value.x, value.y, z);
}

}
