#include "grading/stress/probes/stacked.h"
#include "grading/stress/rounding.h"
#include "grading/stress/stacks.h"
#include "grading/stress/stress.h"

// Rays between mirrors and through glass: what each meets next is known by its height alone.
namespace stress::recursive {
namespace {

    std::string describe(const RaysInStack& query)
    {
        return fmt::format("renderRay, to depth {}, from {} towards {} of a {}", query.maxDepth,
            exactly(query.rays[0][0]), exactly(query.rays[0][1]), describeStack(query.stack));
    }

    // A ray on its way: above the pane with the index next - 1 and below that with the index next.
    struct Way {
        int next;
        bool isUp;
    };

    // Exactly so many panes, one after the other, down to the last depth; the light is white, and a hit has the
    // colour kd.
    glm::dvec3 colorAlong(const Stack& stack, Way way, uint32_t depthsLeft)
    {
        const int met = way.isUp ? way.next : way.next - 1;
        if (met < 0 || met >= static_cast<int>(stack.count))
            return glm::dvec3(0.0);
        const Pane& pane = stack.panes[static_cast<std::size_t>(met)];
        glm::dvec3 color(pane.kd);
        if (depthsLeft == 0)
            return color;
        if (pane.ks != glm::vec3(0.0f))
            color += glm::dvec3(pane.ks) * colorAlong(stack, { way.next, !way.isUp }, depthsLeft - 1);
        const double alpha = static_cast<double>(pane.transparency);
        if (alpha != 1.0)
            color = glm::mix(
                colorAlong(stack, { way.next + (way.isUp ? 1 : -1), way.isUp }, depthsLeft - 1), color, alpha);
        return color;
    }

    Way wayOf(const Stack& stack, const std::array<glm::vec3, 2>& ray)
    {
        int below = 0;
        while (below < static_cast<int>(stack.count) && stack.panes[static_cast<std::size_t>(below)].height < ray[0].z)
            ++below;
        return { below, ray[1].z > ray[0].z };
    }

    Judgement judge(const RaysInStack& query, const Colors& came)
    {
        Judgement worst;
        for (std::size_t i = 0; i < came.size(); ++i) {
            const glm::dvec3 color = colorAlong(query.stack, wayOf(query.stack, query.rays[i]), query.maxDepth);
            // At each depth a few roundings of a sum of what has no sign.
            Judgement judgement = judgeUlps(came[i], color, color, 4.0 + 3.0 * query.maxDepth);
            if (!judgement.isRight) {
                judgement.expected += fmt::format(" of ray {} of 16", i);
                return judgement;
            }
            worst.ulps = std::max(worst.ulps, judgement.ulps);
        }
        return worst;
    }

    const Question<RaysInStack, Colors> rays { "stress.rays_in_stack", describe, judge };

    // From above all panes or from below them.
    std::array<glm::vec3, 2> rayThrough(Random& random, const Stack& stack)
    {
        const float top = stack.panes[stack.count - 1].height;
        const glm::vec3 above { random.vec2(-0.5f, 0.5f), top + random.uniform(0.1f, 1.0f) };
        const glm::vec3 below { random.vec2(-0.5f, 0.5f), stack.panes[0].height - random.uniform(0.1f, 1.0f) };
        return random.integer(0, 1) == 0 ? std::array { above, below } : std::array { below, above };
    }

    // From between two mirrors, no flatter than to meet them seven times: at most 0.35 / 0.3 of the gap to a side each,
    // which of the widest gap is 7.7 in all, and they are 8 wide.
    std::array<glm::vec3, 2> rayBetween(Random& random, const Stack& stack)
    {
        const float lower = stack.panes[0].height, upper = stack.panes[1].height;
        const glm::vec3 from { random.vec2(-0.3f, 0.3f), glm::mix(lower, upper, random.uniform(0.3f, 0.7f)) };
        const glm::vec2 to = glm::vec2(from) + (upper - lower) * random.vec2(-0.35f, 0.35f);
        return { from, glm::vec3(to, random.integer(0, 1) == 0 ? lower : upper) };
    }

    using RayOf = std::array<glm::vec3, 2> (*)(Random&, const Stack&);

    RaysInStack withRays(Random& random, const Stack& stack, RayOf rayOf, uint32_t maxDepth = 6)
    {
        RaysInStack query { stack, maxDepth };
        for (auto& ray : query.rays)
            ray = rayOf(random, stack);
        return query;
    }

    Stack facingMirrors(Random& random, float gap, Stack stack = {})
    {
        for (const float height : { 0.0f, gap })
            stack.add({ .height = height, .kd = random.color(), .ks = random.color() });
        return stack;
    }

    const Stress glass("recursion.glass.anywhere", rays,
        randomly<RaysInStack>(10'000,
            [](Random& random) {
                Stack stack = anyStack(random);
                addGlass(random, stack, random.integer(1, 64));
                return withRays(random, stack, rayThrough, static_cast<uint32_t>(random.integer(0, 6)));
            }),
        16);
    const Stress mirrors("recursion.mirrors.anywhere", rays,
        randomly<RaysInStack>(10'000,
            [](Random& random) {
                const float gap = magnitude(random, 0.02f, 1.0f);
                const Stack stack = facingMirrors(random, gap, anyStack(random));
                return withRays(random, stack, rayBetween, static_cast<uint32_t>(random.integer(0, 6)));
            }),
        16);

    // Special cases are the same for everybody.
    RaysInStack panes(const std::vector<Pane>& panes, RayOf rayOf, uint32_t maxDepth = 6)
    {
        Random random { 5 };
        Stack stack;
        for (const Pane& pane : panes)
            stack.add(pane);
        return withRays(random, stack, rayOf, maxDepth);
    }

    std::vector<Pane> layers(int count, float alpha)
    {
        std::vector<Pane> all;
        for (int i = 0; i < count; ++i)
            all.push_back(
                { .height = 0.02f * static_cast<float>(i), .kd = { 0.8f, 0.4f, 0.6f }, .transparency = alpha });
        return all;
    }

    std::vector<Pane> mirrorsOf(const glm::vec3& ks, float gap = 1.0f, const glm::vec3& kd = glm::vec3(1.0f))
    {
        return { { .height = 0.0f, .kd = kd, .ks = ks }, { .height = gap, .kd = kd, .ks = ks } };
    }

    RaysInStack resized(RaysInStack query, float factor)
    {
        for (glm::vec3* const axis : { &query.stack.right, &query.stack.away, &query.stack.up })
            *axis *= factor;
        return query;
    }

    constexpr glm::vec3 white { 1.0f };

    const Stress special("recursion.stack.special", rays,
        constructed<RaysInStack>({
            { "facing mirrors that lose nothing", panes(mirrorsOf(white), rayBetween) },
            { "facing mirrors, depth 0", panes(mirrorsOf(white), rayBetween, 0) },
            { "facing mirrors, depth 1", panes(mirrorsOf(white), rayBetween, 1) },
            { "facing mirrors, depth 5", panes(mirrorsOf(white), rayBetween, 5) },
            { "facing mirrors of one colour", panes(mirrorsOf({ 0.0f, 1.0f, 0.0f }), rayBetween) },
            { "facing mirrors without light of their own", panes(mirrorsOf(white, 1.0f, glm::vec3(0.0f)), rayBetween) },
            { "facing mirrors that gain", panes(mirrorsOf(glm::vec3(1e3f)), rayBetween) },
            { "facing mirrors that gain as much as a float holds", panes(mirrorsOf(glm::vec3(1e6f)), rayBetween) },
            { "facing mirrors that lose all but the least float", panes(mirrorsOf(glm::vec3(1e-7f)), rayBetween) },
            { "facing mirrors close together", panes(mirrorsOf(white, 0.02f), rayBetween) },
            { "facing mirrors of 1e-6", resized(panes(mirrorsOf(white), rayBetween), 1e-6f) },
            { "facing mirrors of 1e6", resized(panes(mirrorsOf(white), rayBetween), 1e6f) },
            { "one layer of glass", panes(layers(1, 0.5f), rayThrough) },
            { "six layers of glass", panes(layers(6, 0.5f), rayThrough) },
            { "seven layers of glass", panes(layers(7, 0.5f), rayThrough) },
            { "64 layers of glass", panes(layers(64, 0.5f), rayThrough) },
            { "64 layers of glass, depth 0", panes(layers(64, 0.5f), rayThrough, 0) },
            { "64 layers of glass, depth 1", panes(layers(64, 0.5f), rayThrough, 1) },
            { "64 layers of glass, depth 5", panes(layers(64, 0.5f), rayThrough, 5) },
            { "64 clear layers", panes(layers(64, 0.0f), rayThrough) },
            { "64 layers that are nearly opaque", panes(layers(64, 0x1.fffffep-1f), rayThrough) },
            { "64 opaque layers", panes(layers(64, 1.0f), rayThrough) },
            { "64 layers of 1e-6", resized(panes(layers(64, 0.5f), rayThrough), 1e-6f) },
            { "64 layers of 1e6", resized(panes(layers(64, 0.5f), rayThrough), 1e6f) },
            { "mirrors of glass",
                panes({ { .height = 0.0f, .ks = white, .transparency = 0.5f },
                          { .height = 1.0f, .ks = white, .transparency = 0.5f } },
                    rayBetween) },
        }),
        16);

}
}
