#include "grading/stress/probes/stacked.h"
#include "grading/stress/rounding.h"
#include "grading/stress/stacks.h"
#include "grading/stress/stress.h"

// Lights above, between and below panes: what is in between is known by the order of heights alone.
namespace stress::light_visibility {
namespace {

    std::string describe(const LightBehindStack& query)
    {
        return fmt::format("visibilityOfLightSample... of a point at height 0 of a {}, and a light at height {}",
            describeStack(query.stack), exactly(query.looks[0].light.z));
    }

    bool isBetween(const Pane& pane, const Look& look)
    {
        return pane.height > 0.0f && pane.height < look.light.z;
    }

    // kd * (1 - alpha) of each pane in between.
    glm::dvec3 leftOf(const Stack& stack, const Look& look)
    {
        glm::dvec3 left { 1.0 };
        for (uint32_t i = 0; i < stack.count; ++i)
            if (isBetween(stack.panes[i], look))
                left *= glm::dvec3(stack.panes[i].kd) * (1.0 - static_cast<double>(stack.panes[i].transparency));
        return left;
    }

    bool isOpen(const Stack& stack, const Look& look)
    {
        return std::none_of(stack.panes.begin(), stack.panes.begin() + stack.count,
            [&](const Pane& pane) { return isBetween(pane, look); });
    }

    Judgement judgeLook(const Stack& stack, const Look& look, const Seen& came)
    {
        const bool isVisible = isOpen(stack, look);
        if ((came.isVisible == 1) != isVisible)
            return wrong(came.isVisible ? "visible" : "not visible", isVisible ? "visible" : "not visible");
        const glm::dvec3 left = leftOf(stack, look);
        return judgeUlps(came.left, left, left, 2.0 + 1.5 * stack.count); // three roundings for each
    }

    Judgement judge(const LightBehindStack& query, const AllSeen& came)
    {
        Judgement worst;
        for (std::size_t i = 0; i < came.size(); ++i) {
            Judgement judgement = judgeLook(query.stack, query.looks[i], came[i]);
            if (!judgement.isRight) {
                judgement.expected += fmt::format(" at light {} of 16", i);
                return judgement;
            }
            worst.ulps = std::max(worst.ulps, judgement.ulps);
        }
        return worst;
    }

    const Question<LightBehindStack, AllSeen> visibility { "stress.visibility", describe, judge };

    // What bounds the gaps that lights may be in.
    std::vector<float> heightsOf(const Stack& stack)
    {
        std::vector<float> heights { 0.0f };
        for (uint32_t i = 0; i < stack.count; ++i)
            if (stack.panes[i].height > 0.0f)
                heights.push_back(stack.panes[i].height);
        heights.push_back(heights.back() + 0.02f);
        return heights;
    }

    // Lights in the middle of gaps, over points that the stack is wide enough for.
    LightBehindStack withLights(Random& random, const Stack& stack)
    {
        const std::vector<float> heights = heightsOf(stack);
        LightBehindStack query { stack };
        for (auto& [point, camera, light] : query.looks) {
            const auto gap = static_cast<std::size_t>(random.integer(1, static_cast<int>(heights.size()) - 1));
            const float height = glm::mix(heights[gap - 1], heights[gap], random.uniform(0.4f, 0.6f));
            point = { random.vec2(-0.3f, 0.3f), 0.0f };
            camera = { random.vec2(-0.5f, 0.5f), random.uniform(0.5f, 1.5f) };
            light = { glm::vec2(point) + height * random.vec2(-0.7f, 0.7f), height };
        }
        return query;
    }

    const Stress anywhere("light.visibility.anywhere", visibility,
        randomly<LightBehindStack>(12'000,
            [](Random& random) {
                Stack stack = anyStack(random);
                if (random.integer(0, 1) == 0)
                    stack.add({ .height = 0.0f }); // the surface itself
                addGlass(random, stack, random.integer(0, 8));
                return withLights(random, stack);
            }),
        16);

    // The same for everybody: special cases have no random numbers of their own.
    LightBehindStack special(const Stack& stack)
    {
        Random random { 7 };
        return withLights(random, stack);
    }

    LightBehindStack layers(int count, float alpha)
    {
        Random random { 3 };
        Stack stack;
        addGlass(random, stack, count);
        for (uint32_t i = 0; i < stack.count; ++i)
            stack.panes[i].transparency = alpha;
        return special(stack);
    }

    LightBehindStack panesAt(std::initializer_list<float> heights, float alpha, const glm::vec3& kd = glm::vec3(0.7f))
    {
        Stack stack;
        for (const float height : heights)
            stack.add({ .height = height, .kd = kd, .transparency = alpha });
        return special(stack);
    }

    LightBehindStack resized(LightBehindStack query, float factor, const glm::vec3& center = glm::vec3(0.0f))
    {
        Stack& stack = query.stack;
        stack.center = center;
        for (glm::vec3* const axis : { &stack.right, &stack.away, &stack.up })
            *axis *= factor;
        return query;
    }

    const Stress byHand("light.visibility.special", visibility,
        constructed<LightBehindStack>({
            { "nothing at all", layers(0, 0.5f) },
            { "the surface itself", panesAt({ 0.0f }, 1.0f) },
            { "the surface itself, of glass", panesAt({ 0.0f }, 0.5f) },
            { "one opaque pane", panesAt({ 0.5f }, 1.0f) },
            { "one clear pane", panesAt({ 0.5f }, 0.0f) },
            { "one pane of glass that is nearly opaque", panesAt({ 0.5f }, 0x1.fffffep-1f) },
            { "one pane of black glass", panesAt({ 0.5f }, 0.5f, glm::vec3(0.0f)) },
            { "a pane that nearly touches the point", panesAt({ 0.0f, 5e-3f }, 0.5f) },
            { "an opaque pane that nearly touches the point", panesAt({ 0.0f, 5e-3f }, 1.0f) },
            { "a pane below the surface", panesAt({ -0.01f, 0.0f }, 1.0f) },
            { "two panes that nearly touch", panesAt({ 0.0f, 0.5f, 0.505f }, 0.5f) },
            { "64 layers of clear glass", layers(64, 0.0f) },
            { "64 layers of glass", layers(64, 0.25f) },
            { "64 layers of which only the last is opaque",
                [] {
                    LightBehindStack query = layers(64, 0.25f);
                    query.stack.panes[63].transparency = 1.0f;
                    return query;
                }() },
            { "a stack of 1e-3", resized(layers(8, 0.25f), 1e-3f) },
            { "a stack of 1e-6", resized(layers(8, 0.25f), 1e-6f) },
            { "a stack of 1e6", resized(layers(8, 0.25f), 1e6f) },
            { "a stack two of its sizes away", resized(layers(8, 0.25f), 1.0f, glm::vec3(1.2f)) },
            { "a slanted stack of 1e3",
                [] {
                    LightBehindStack query = layers(8, 0.25f);
                    query.stack.right = { 800.0f, 0.0f, -600.0f };
                    query.stack.up = { 600.0f, 0.0f, 800.0f };
                    query.stack.away = { 0.0f, 1000.0f, 0.0f };
                    return query;
                }() },
        }),
        16);

}
}
