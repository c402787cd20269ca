#include "grading/stress/probes/gradient.h"
#include "grading/stress/rounding.h"
#include "grading/stress/stress.h"
#include <cfloat>

namespace stress::shading_gradient {
namespace {

    using Component = LinearGradient::Component;

    std::span<const Component> componentsOf(const GradientQuery& query)
    {
        return std::span(query.components).first(query.count);
    }

    std::string describe(const GradientQuery& query)
    {
        std::string text;
        for (const Component& component : componentsOf(query))
            text += fmt::format(" {{{}, {}}}", exactly(component.t), exactly(component.color));
        return fmt::format("LinearGradient::sample({}) of{}", exactly(query.ti), text.empty() ? " none" : text);
    }

    bool hasNaN(const GradientQuery& query)
    {
        const auto components = componentsOf(query);
        return std::isnan(query.ti)
            || std::any_of(components.begin(), components.end(), [](const auto& c) { return std::isnan(c.t); });
    }

    // Where a position is no number nothing is prescribed but that it be seen nowhere: no brighter than the colours.
    Judgement judgeHull(const GradientQuery& query, const glm::vec3& came)
    {
        glm::dvec3 brightest { 0.0 };
        for (const Component& component : componentsOf(query))
            brightest = glm::max(brightest, glm::dvec3(component.color));
        return judgeInside(came, glm::dvec3(0.0), brightest * (1.0 + ulpOfOne));
    }

    struct Neighbours {
        double below = -INFINITY, above = INFINITY; // positions; one that is missing is the other
    };

    Neighbours neighboursOf(const GradientQuery& query)
    {
        Neighbours neighbours;
        for (const Component& component : componentsOf(query)) {
            const auto t = static_cast<double>(component.t);
            if (component.t <= query.ti)
                neighbours.below = std::max(neighbours.below, t);
            if (component.t >= query.ti)
                neighbours.above = std::min(neighbours.above, t);
        }
        if (std::isinf(neighbours.below))
            neighbours.below = neighbours.above;
        if (std::isinf(neighbours.above))
            neighbours.above = neighbours.below;
        return neighbours;
    }

    // Between one component below and one above. Both differences and their quotient are rounded, and the blend is.
    Judgement judgeBetween(
        const GradientQuery& query, const glm::vec3& came, const Component& below, const Component& above)
    {
        const glm::dvec3 color0(below.color), color1(above.color);
        const double gap = static_cast<double>(above.t) - static_cast<double>(below.t);
        const double weight = gap > 0.0 ? (static_cast<double>(query.ti) - static_cast<double>(below.t)) / gap : 0.0;
        return judgeUlps(came, glm::mix(color0, color1, weight), glm::max(color0, color1), 6.0);
    }

    Judgement judge(const GradientQuery& query, const glm::vec3& came)
    {
        if (query.count == 0)
            return judgeInside(came, glm::dvec3(0.0), glm::dvec3(0.0));
        if (hasNaN(query))
            return judgeHull(query, came);
        const auto [below, above] = neighboursOf(query);
        Judgement judgement;
        for (const Component& a : componentsOf(query)) {
            for (const Component& b : componentsOf(query)) {
                const bool isNeighbour = static_cast<double>(a.t) == below && static_cast<double>(b.t) == above;
                if (!isNeighbour || (below == above && &a != &b)) // of equal positions either colour
                    continue;
                judgement = judgeBetween(query, came, a, b);
                if (judgement.isRight)
                    return judgement;
            }
        }
        return judgement;
    }

    const Question<GradientQuery, glm::vec3> sample { "stress.gradient", describe, judge };

    // Some positions are equal, some differ by a few ulps.
    float position(Random& random)
    {
        if (random.integer(0, 2) == 0)
            return stepped(0.25f * static_cast<float>(random.integer(-4, 4)), random.integer(-1, 1));
        return random.uniform(-1.0f, 1.0f);
    }

    GradientQuery anyQuery(Random& random)
    {
        GradientQuery query;
        query.count = static_cast<uint32_t>(random.integer(1, 8));
        for (uint32_t i = 0; i < query.count; ++i)
            query.components[i] = { position(random), random.color() };
        const auto any = static_cast<std::size_t>(random.integer(0, static_cast<int>(query.count) - 1));
        query.ti
            = random.integer(0, 3) == 0 ? stepped(query.components[any].t, random.integer(-2, 2)) : position(random);
        return query;
    }

    const Stress anywhere("gradient.sample.anywhere", sample, randomly<GradientQuery>(1'000'000, anyQuery));

    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr glm::vec3 red { 1.0f, 0.0f, 0.0f }, grey { 0.3f }, sky { 0.2f, 0.4f, 0.9f };

    GradientQuery of(std::initializer_list<Component> components, float ti)
    {
        GradientQuery query;
        query.ti = ti;
        for (const Component& component : components)
            query.components[query.count++] = component;
        return query;
    }

    const Stress special("gradient.sample.special", sample,
        constructed<GradientQuery>({
            { "no component", of({}, 0.0f) },
            { "no component, NaN", of({}, nan) },
            { "one component, below it", of({ { 0.2f, sky } }, -1.0f) },
            { "one component, at it", of({ { 0.2f, sky } }, 0.2f) },
            { "one component, above it", of({ { 0.2f, sky } }, 1.0f) },
            { "all at one position, at it", of({ { 0.5f, sky }, { 0.5f, red }, { 0.5f, grey } }, 0.5f) },
            { "all at one position, below it", of({ { 0.5f, sky }, { 0.5f, red } }, -0.5f) },
            { "all at one position, above it", of({ { 0.5f, sky }, { 0.5f, red } }, 0.75f) },
            { "zero and minus zero", of({ { -0.0f, sky }, { 0.0f, red } }, 0.0f) },
            { "two that are one float apart", of({ { 0.5f, sky }, { 0x1.000002p-1f, red } }, 0.5f) },
            { "two denormals, between them", of({ { 1e-45f, sky }, { 3e-45f, red } }, 2e-45f) },
            { "falling positions", of({ { 1.0f, sky }, { 0.0f, red }, { -1.0f, grey } }, 0.25f) },
            { "equal ones inside", of({ { 1.0f, sky }, { 0.0f, red }, { 0.0f, grey }, { -1.0f, sky } }, 1e-9f) },
            { "at the first", of({ { -1.0f, sky }, { 1.0f, red } }, -1.0f) },
            { "at the last", of({ { -1.0f, sky }, { 1.0f, red } }, 1.0f) },
            { "a cosine above 1", of({ { -1.0f, sky }, { 1.0f, red } }, 0x1.000002p0f) },
            { "a cosine below -1", of({ { -1.0f, sky }, { 1.0f, red } }, -0x1.000002p0f) },
            { "beside both ends", of({ { -0.5f, sky }, { 0.5f, red } }, 0x1.000002p-1f) },
            { "infinity", of({ { -1.0f, sky }, { 1.0f, red } }, infinity) },
            { "minus infinity", of({ { -1.0f, sky }, { 1.0f, red } }, -infinity) },
            { "black and black", of({ { -1.0f, glm::vec3(0.0f) }, { 1.0f, glm::vec3(0.0f) } }, 0.3f) },
            { "huge colours", of({ { -1.0f, glm::vec3(1e38f) }, { 1.0f, glm::vec3(3e38f) } }, 0.3f) },
            { "sample NaN", of({ { -1.0f, sky }, { 1.0f, red } }, nan) },
            { "one component, sample NaN", of({ { 0.0f, sky } }, nan) },
            { "the first position NaN", of({ { nan, sky }, { 1.0f, red }, { 0.0f, grey } }, 0.3f) },
            { "the last position NaN", of({ { -1.0f, sky }, { 1.0f, red }, { nan, grey } }, 0.3f) },
            { "the only position NaN", of({ { nan, sky } }, 0.3f) },
            { "all NaN", of({ { nan, sky }, { nan, red } }, nan) },
        }));

}
}
