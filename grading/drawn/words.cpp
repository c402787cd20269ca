#include "grading/drawn/words.h"
#include "grading/drawn/near.h"
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <framework/variant_helper.h>

namespace grading {
namespace {

    constexpr std::array<std::pair<glm::vec3, const char*>, 4> names { {
        { { 1.0f, 1.0f, 0.0f }, "yellow" },
        { { 0.0f, 1.0f, 0.0f }, "green" },
        { { 1.0f, 0.0f, 0.0f }, "red" },
        { { 1.0f, 1.0f, 1.0f }, "white" },
    } };

    bool looksLike(const glm::vec3& a, const glm::vec3& b)
    {
        return glm::distance(a, b) <= 0.02f; // five steps of a screen
    }

    std::string nameOf(const glm::vec3& color)
    {
        const auto found = std::ranges::find_if(names, [&](const auto& name) { return looksLike(color, name.first); });
        return found == names.end() ? fmt::format("({:.2g}, {:.2g}, {:.2g})", color.r, color.g, color.b)
                                    : found->second;
    }

    // A sphere at a surface may have a colour of that.
    std::string nameOf(const debug::DrawnSphere& sphere, std::span<const debug::Hit> hits)
    {
        for (const auto& [ray, hitInfo, cause] : hits) {
            const Material& material = hitInfo.material;
            if (isNear(sphere.center, endOf(ray)) && looksLike(sphere.color, material.kd * material.transparency))
                return material.transparency == 1.0f ? "kd" : "kd * alpha";
            if (isNear(sphere.center, endOf(ray)) && looksLike(sphere.color, material.kd))
                return "kd";
        }
        return nameOf(sphere.color);
    }

    // Shapes of a kind at places of a kind, in the order drawn.
    struct Group {
        std::string kind, place;
        std::size_t count = 0;
        std::vector<glm::vec3> colors;
        std::vector<std::string> colorNames, extents; // each once
    };

    void addOnce(std::vector<std::string>& words, const std::string& word)
    {
        if (!word.empty() && std::ranges::find(words, word) == words.end())
            words.push_back(word);
    }

    Group& groupOf(std::vector<Group>& groups, const std::string& kind, const std::string& place)
    {
        const auto found = std::ranges::find_if(
            groups, [&](const Group& group) { return group.kind == kind && group.place == place; });
        return found == groups.end() ? groups.emplace_back(Group { kind, place, 0, {}, {}, {} }) : *found;
    }

    void add(std::vector<Group>& groups, const debug::Drawn& shape, const Surroundings& around)
    {
        static constexpr std::array<const char*, std::variant_size_v<debug::Drawn>> kinds { "ray", "box", "triangle",
            "sphere" };
        Group& group = groupOf(groups, kinds[shape.index()], placeOf(shape, around));
        ++group.count;
        addOnce(group.extents, extentOf(shape, around));
        const auto addColor = [&](const glm::vec3& color, const std::string& name) {
            group.colors.push_back(color);
            addOnce(group.colorNames, name);
        };
        std::visit(make_visitor([&](const debug::DrawnRay& ray) { addColor(ray.color, nameOf(ray.color)); },
                       [&](const debug::DrawnBox& box) { addColor(box.color, nameOf(box.color)); },
                       [](const debug::DrawnTriangle&) {},
                       [&](const debug::DrawnSphere& sphere) { addColor(sphere.color, nameOf(sphere, around.hits)); }),
            shape);
    }

    bool isBetweenYellowAndRed(const glm::vec3& color)
    {
        return looksLike(color, { 1.0f, std::clamp(color.g, 0.0f, 1.0f), 0.0f });
    }

    constexpr std::size_t mostListed = 4;

    std::string listed(const std::vector<std::string>& words)
    {
        if (words.size() <= mostListed)
            return fmt::format("{}", fmt::join(words, ", "));
        return fmt::format(
            "{} and {} more", fmt::join(words.begin(), words.begin() + mostListed, ", "), words.size() - mostListed);
    }

    // Many are told by the first and the last.
    std::string colorsOf(const Group& group)
    {
        const std::vector<glm::vec3>& colors = group.colors;
        const std::string ends = fmt::format("from {} to {}", nameOf(colors.front()), nameOf(colors.back()));
        if (group.colorNames.size() > 2 && std::ranges::all_of(colors, isBetweenYellowAndRed)) {
            const bool isEverRedder = std::ranges::is_sorted(colors, std::ranges::greater {}, &glm::vec3::g);
            return ends + (isEverRedder ? ", ever redder" : ", but not ever redder");
        }
        if (group.colorNames.size() > mostListed)
            return fmt::format("in {} colours {}", group.colorNames.size(), ends);
        return listed(group.colorNames);
    }

    std::string plural(const std::string& kind, std::size_t count)
    {
        return fmt::format("{} {}{}", count, kind, count == 1 ? "" : kind == "box" ? "es" : "s");
    }

    std::string toText(const Group& group, std::size_t numLightSamples)
    {
        std::string text = plural(group.kind, group.count);
        if (!group.place.empty())
            text += " " + group.place;
        if (group.place == toALight)
            text += fmt::format(" ({} light samples)", numLightSamples);
        if (!group.colorNames.empty())
            text += ", " + colorsOf(group);
        return group.extents.empty() ? text : text + ", " + listed(group.extents);
    }

}

std::vector<std::string> inWords(const Surroundings& surroundings)
{
    std::vector<Group> groups;
    for (const debug::Drawn& shape : surroundings.drawing)
        add(groups, shape, surroundings);
    std::vector<std::string> lines;
    for (const Group& group : groups)
        lines.push_back(toText(group, surroundings.numLightSamples));
    return lines.empty() ? std::vector<std::string> { "nothing" } : lines;
}

}
