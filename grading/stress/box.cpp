#include "grading/stress/oracle/crossing.h"
#include "grading/stress/probes/rays.h"
#include "grading/stress/stress.h"
#include "grading/stress/text.h"

namespace stress::box {
namespace {

    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr float infinitelyFar = std::numeric_limits<float>::infinity();

    std::string describe(const BoxRay& input)
    {
        return fmt::format("intersectRayWithShape of the box from {} to {} by {}", exactly(input.box.lower),
            exactly(input.box.upper), exactly(input.ray));
    }

    // Where the line of the ray is in the box, from entry to exit; nowhere if that is before it begins.
    struct Stay {
        double entry = 0.0, exit = infinity;
    };

    // Kay and Kajiya's slabs, in double precision, where differences of floats and quotients are good to 2^-52. A
    // component so small that its reciprocal may be no float counts as none: a face that is 1 away is then out of a
    // float's reach.
    Stay stayIn(const AxisAlignedBox& box, const Ray& ray)
    {
        Stay stay;
        for (int axis = 0; axis < 3; ++axis) {
            const double d = ray.direction[axis], origin = ray.origin[axis];
            const double toLower = box.lower[axis] - origin, toUpper = box.upper[axis] - origin;
            if (std::abs(d) < std::numeric_limits<float>::min()) {
                if (toLower > 0.0 || toUpper < 0.0)
                    return { infinity, -infinity };
                continue;
            }
            stay.entry = std::max(stay.entry, std::min(toLower / d, toUpper / d));
            stay.exit = std::min(stay.exit, std::max(toLower / d, toUpper / d));
        }
        return stay;
    }

    // No box is missed, faces, edges and corners included; a box that is passed by more than roundings is. A distance
    // has three: of a difference, a reciprocal and a product.
    Judgement judge(const BoxRay& input, const Met& met)
    {
        constexpr double roundings = 4.0 * rounding;
        const auto [entry, exit] = stayIn(input.box, input.ray);
        const double end = static_cast<double>(input.ray.t), t = static_cast<double>(met.t);
        const bool mayHit = entry <= exit * (1.0 + 4.0 * roundings) && entry <= end * (1.0 + roundings);
        const bool mustHit
            = entry <= exit && entry * (1.0 + roundings) <= end && entry <= std::numeric_limits<float>::max();
        const std::string expected = fmt::format("in the box from t = {} to {}", exactly(entry), exactly(exit));
        const double ulps = met.isHit && entry > 0.0 ? std::abs(t - entry) / (2.0 * rounding * entry) : 0.0;
        const std::string came = met.isHit ? "a hit at t = " + exactly(met.t) : "none, t = " + exactly(met.t);
        const bool isRight = met.isHit ? mayHit && t <= end && std::abs(t - entry) <= roundings * entry
                                       : !mustHit && met.t == input.ray.t;
        return isRight ? right(ulps) : wrong(came, expected, ulps);
    }

    const Question<BoxRay, Met> question { "stress.box", describe, judge };

    // A box about as large as the size, flat along an axis now and then, and a ray from outside or inside to a point in
    // it or close by.
    BoxRay make(Random& random, float size)
    {
        const glm::vec3 a = size * random.vec3(-1.0f, 1.0f), b = size * random.vec3(-1.0f, 1.0f);
        AxisAlignedBox box { glm::min(a, b), glm::max(a, b) };
        if (const int axis = random.integer(0, 5); axis < 3)
            box.upper[axis] = box.lower[axis];
        const glm::vec3 target = glm::mix(box.lower, box.upper, random.vec3(-0.2f, 1.2f));
        const glm::vec3 origin = random.integer(0, 3) == 0 ? glm::mix(box.lower, box.upper, random.vec3())
                                                           : size * magnitude(random, 0.1f, 1e6f) * random.direction();
        Ray ray { origin, (target - origin) * magnitude(random, 1e-3f, 1e3f) };
        if (random.integer(0, 3) == 0)
            ray.t = random.uniform(0.0f, 2.0f) * glm::distance(origin, target) / glm::length(ray.direction);
        return { box, ray };
    }

    const Stress scales("box.scales", question,
        randomly<BoxRay>(700'000, [](Random& random) { return make(random, magnitude(random, 1e-6f, 1e6f)); }));

    // Along an axis, or in a plane of two, with zeros of either sign; often in the plane of a face.
    const Stress axes("box.axes", question, randomly<BoxRay>(700'000, [](Random& random) {
        BoxRay input = make(random, magnitude(random, 1e-3f, 1e3f));
        const int moving = random.integer(0, 2);
        for (int axis = 0; axis < 3; ++axis) {
            if (axis != moving && random.integer(0, 3) > 0) {
                input.ray.direction[axis] = random.integer(0, 1) == 0 ? -0.0f : 0.0f;
                const float places[] { input.box.lower[axis], input.box.upper[axis],
                    glm::mix(input.box.lower[axis], input.box.upper[axis], random.uniform(-0.2f, 1.2f)) };
                input.ray.origin[axis] = places[random.integer(0, 2)];
            }
        }
        return input;
    }));

    // On a face, an edge or a corner.
    const Stress touching("box.touching", question, randomly<BoxRay>(700'000, [](Random& random) {
        BoxRay input = make(random, magnitude(random, 1e-3f, 1e3f));
        for (int axis = 0; axis < 3; ++axis)
            if (random.integer(0, 1) == 0)
                input.ray.origin[axis] = random.integer(0, 1) == 0 ? input.box.lower[axis] : input.box.upper[axis];
        return input;
    }));

    // Of whole numbers, through edges and corners: nothing is rounded.
    const Stress lattice("box.lattice", question, randomly<BoxRay>(700'000, [](Random& random) {
        const auto point = [&] {
            const int x = random.integer(-3, 3), y = random.integer(-3, 3);
            return glm::vec3(x, y, random.integer(-3, 3));
        };
        const auto step = [&] { return static_cast<float>(random.integer(-2, 2)); };
        const glm::vec3 a = point(), b = point();
        const glm::vec3 direction { step(), step(), step() };
        return BoxRay { { glm::min(a, b), glm::max(a, b) },
            { point(), direction == glm::vec3(0.0f) ? glm::vec3(-0.0f, 1.0f, -0.0f) : direction } };
    }));

    // Next to nothing along an axis, often in the plane of a face.
    const Stress denormal("box.denormal", question, randomly<BoxRay>(200'000, [](Random& random) {
        const auto whole = [&] { return static_cast<float>(random.integer(-3, 3)); };
        const glm::vec3 lower { whole(), whole(), whole() };
        BoxRay input { { lower, lower + 4.0f * glm::vec3(random.uniform(0.5f, 1.0f) < 0.75f ? 0.25f : 1.0f) }, {} };
        input.ray.direction = { 1.0f, random.uniform(-1.0f, 1.0f), random.integer(0, 1) == 0 ? 1e-40f : -3e-45f };
        input.ray.origin = { whole(), whole(), whole() };
        if (random.integer(0, 1) == 0)
            std::swap(input.ray.direction.x, input.ray.direction.z);
        return input;
    }));

    const AxisAlignedBox unit { glm::vec3(0.0f), glm::vec3(1.0f) };
    const AxisAlignedBox sheet { { 0, 0, 0 }, { 1, 1, 0 } };
    const AxisAlignedBox everywhere { glm::vec3(-infinitelyFar), glm::vec3(infinitelyFar) };

    const Stress special("box.special", question,
        constructed<BoxRay>({
            { "along x", { unit, { { -1, 0.5f, 0.5f }, { 1, 0, 0 } } } },
            { "along -x", { unit, { { 2, 0.5f, 0.5f }, { -1, 0, 0 } } } },
            { "along y", { unit, { { 0.5f, -1, 0.5f }, { 0, 1, 0 } } } },
            { "along -y", { unit, { { 0.5f, 2, 0.5f }, { 0, -1, 0 } } } },
            { "along z", { unit, { { 0.5f, 0.5f, -1 }, { 0, 0, 1 } } } },
            { "along -z", { unit, { { 0.5f, 0.5f, 2 }, { 0, 0, -1 } } } },
            { "along x with negative zeros", { unit, { { -1, 0.5f, 0.5f }, { 1, -0.0f, -0.0f } } } },
            { "along x in a face", { unit, { { -1, 0, 0.5f }, { 1, 0, 0 } } } },
            { "along x in the face opposite", { unit, { { -1, 1, 0.5f }, { 1, 0, 0 } } } },
            { "along x in a face, negative zeros", { unit, { { -1, 0, 0.5f }, { 1, -0.0f, -0.0f } } } },
            { "along x in the face opposite, negative zeros", { unit, { { -1, 1, 0.5f }, { 1, -0.0f, -0.0f } } } },
            { "along an edge", { unit, { { -1, 0, 0 }, { 1, 0, 0 } } } },
            { "along the edge opposite", { unit, { { -1, 1, 1 }, { 1, -0.0f, 0 } } } },
            { "along x, beside", { unit, { { -1, 1.5f, 0.5f }, { 1, 0, 0 } } } },
            { "along x, just beside", { unit, { { -1, 1.00001f, 0.5f }, { 1, 0, 0 } } } },
            { "along x, away", { unit, { { -1, 0.5f, 0.5f }, { -1, 0, 0 } } } },
            { "from a corner, in", { unit, { { 0, 0, 0 }, { 1, 1, 1 } } } },
            { "from a corner, out", { unit, { { 0, 0, 0 }, { -1, -1, -1 } } } },
            { "from a corner, along an edge", { unit, { { 0, 0, 0 }, { 1, 0, 0 } } } },
            { "from a corner, back along an edge", { unit, { { 0, 0, 0 }, { -1, 0, 0 } } } },
            { "from a face, in", { unit, { { 0, 0.5f, 0.5f }, { 1, 0, 0 } } } },
            { "from a face, out", { unit, { { 0, 0.5f, 0.5f }, { -1, 0, 0 } } } },
            { "from a face, in its plane", { unit, { { 0, 0.5f, 0.5f }, { 0, 1, 0 } } } },
            { "through a corner", { unit, { { -1, -1, -1 }, { 1, 1, 1 } } } },
            { "through an edge", { unit, { { -1, -1, 0.5f }, { 1, 1, 0 } } } },
            { "touches an edge", { unit, { { -1, 0, 0.5f }, { 1, -1, 0 } } } },
            { "touches an edge from above", { unit, { { -1, 2, 0.5f }, { 1, -1, 0 } } } },
            { "inside", { unit, { { 0.5f, 0.5f, 0.5f }, { 0, 0, 1 } } } },
            { "inside, ends inside", { unit, { { 0.5f, 0.5f, 0.5f }, { 0, 0, 1 }, 0.1f } } },
            { "inside, no length", { unit, { { 0.5f, 0.5f, 0.5f }, { 0, 0, 1 }, 0.0f } } },
            { "ends at the face", { unit, { { -1, 0.5f, 0.5f }, { 1, 0, 0 }, 1.0f } } },
            { "ends before the face", { unit, { { -1, 0.5f, 0.5f }, { 1, 0, 0 }, 0.5f } } },
            { "no end", { unit, { { -1, 0.5f, 0.5f }, { 1, 0, 0 }, infinitelyFar } } },
            { "flat, straight on", { sheet, { { 0.5f, 0.5f, 1 }, { 0, 0, -1 } } } },
            { "flat, aslant", { sheet, { { -0.5f, 0.5f, 1 }, { 1, 0, -1 } } } },
            { "flat, in its plane", { sheet, { { -1, 0.5f, 0 }, { 1, 0, 0 } } } },
            { "flat, in its plane with a negative zero", { sheet, { { -1, 0.5f, 0 }, { 1, 0, -0.0f } } } },
            { "flat, beside its plane", { sheet, { { -1, 0.5f, 1e-6f }, { 1, 0, 0 } } } },
            { "flat, from on it", { sheet, { { 0.5f, 0.5f, 0 }, { 0, 0, 1 } } } },
            { "a segment, along it", { { { 0, 0, 0 }, { 1, 0, 0 } }, { { -1, 0, 0 }, { 1, 0, 0 } } } },
            { "a segment, across it", { { { 0, 0, 0 }, { 1, 0, 0 } }, { { 0.5f, -1, 0 }, { 0, 1, 0 } } } },
            { "a point, met", { { glm::vec3(1), glm::vec3(1) }, { { 0, 0, 0 }, { 1, 1, 1 } } } },
            { "a point, missed", { { glm::vec3(1), glm::vec3(1) }, { { 0, 0, 0 }, { 1, 1, 0.5f } } } },
            { "a point, from it", { { glm::vec3(1), glm::vec3(1) }, { { 1, 1, 1 }, { 0, 1, 0 } } } },
            { "a denormal component, inside its slab", { unit, { { -1, 0.5f, 0.5f }, { 1, 1e-40f, 0 } } } },
            { "a denormal component, outside its slab", { unit, { { -1, 2, 0.5f }, { 1, -1e-40f, 0 } } } },
            { "the least denormal component", { unit, { { -1, 0.5f, 0.5f }, { 1, -1e-45f, 1e-45f } } } },
            { "a huge direction", { unit, { { -1, 0.5f, 0.5f }, { 1e30f, 0, 0 } } } },
            { "a tiny direction", { unit, { { -1, 0.5f, 0.5f }, { 1e-30f, 0, 0 } } } },
            { "everywhere", { everywhere, { { 1, 2, 3 }, { 1, 1, 1 } } } },
            { "everywhere, along an axis", { everywhere, { { 1, 2, 3 }, { 0, 1, -0.0f } } } },
            { "half of space, from outside",
                { { { 0, -infinitelyFar, -infinitelyFar }, glm::vec3(infinitelyFar) },
                    { { -3, 1, 1 }, { 1, 0, 0 } } } },
            { "half of space, away from it",
                { { { 0, -infinitelyFar, -infinitelyFar }, glm::vec3(infinitelyFar) },
                    { { -3, 1, 1 }, { -1, 0, 0 } } } },
            { "a huge box from inside", { { glm::vec3(-1e30f), glm::vec3(1e30f) }, { { 1, 2, 3 }, { 0, 0, 1 } } } },
            { "a huge box from outside",
                { { glm::vec3(-1e18f), glm::vec3(1e18f) }, { { 0, 0, -3e18f }, { 0, 0, 1 } } } },
            { "a tiny box far away", { { glm::vec3(1e6f), glm::vec3(1000001) }, { { 0, 0, 0 }, { 1, 1, 1 } } } },
            { "a tiny box far away, passed",
                { { glm::vec3(1e6f), glm::vec3(1000001) }, { { 0, 0, 0 }, { 1, 1, 1.0001f } } } },
        }));

}
}
