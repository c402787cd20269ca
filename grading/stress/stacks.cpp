#include "grading/stress/stacks.h"
#include "grading/stress/text.h"

namespace stress {

std::string describeStack(const Stack& stack)
{
    std::string text = fmt::format("stack at {}, axes {}, {} and {}, of {} panes:", exactly(stack.center),
        exactly(stack.right), exactly(stack.away), exactly(stack.up), stack.count);
    for (uint32_t i = 0; i < stack.count; ++i) {
        const auto& [height, kd, ks, transparency] = stack.panes[i];
        text += fmt::format(
            " {{height {}, kd {}, ks {}, alpha {}}}", exactly(height), exactly(kd), exactly(ks), exactly(transparency));
    }
    return text;
}

Stack anyStack(Random& random)
{
    Stack stack;
    const float size = magnitude(random, 1e-3f, 1e3f);
    const glm::vec3 up = random.direction();
    const glm::vec3 right = glm::normalize(glm::cross(up, random.direction()));
    stack.up = size * up;
    stack.right = size * right;
    stack.away = size * glm::cross(up, right);
    const float angle = random.uniform(0.0f, 6.28318531f), distance = random.uniform(2.0f, 3.0f);
    stack.center = distance * (std::cos(angle) * stack.right + std::sin(angle) * stack.away)
        + random.uniform(-1.0f, 1.0f) * stack.up;
    return stack;
}

void addGlass(Random& random, Stack& stack, int count)
{
    float height = stack.count == 0 ? 0.0f : stack.panes[stack.count - 1].height;
    for (int i = 0; i < count; ++i) {
        height += random.uniform(0.01f, 0.03f);
        stack.add({ .height = height, .kd = random.vec3(0.4f, 1.0f), .transparency = random.uniform(0.0f, 0.8f) });
    }
}

}
