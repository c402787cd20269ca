#include "grading/stress/probes/spawned.h"
#include "grading/stress/oracle/crossing.h"
#include "grading/stress/shapes.h"
#include "grading/stress/stress.h"
#include "grading/stress/text.h"

namespace stress::spawned {
namespace {

    // Where a ray starts, seen from the surface that sends it on.
    struct Start {
        double height; // over the surface, on the side that the ray came from
        double distance; // from the hit point, in sizes of the numbers that the point is calculated from
    };

    Start startOf(const TriangleRay& input, const Spawned& spawned, const Ray& ray)
    {
        const grading::Corners corners = grading::cornersOf(input.triangle);
        const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        const glm::dvec3 d { input.ray.direction }, from { input.ray.origin }, to { ray.origin };
        const double side = glm::dot(normal, d) > 0.0 ? -1.0 : 1.0;
        const glm::dvec3 way = static_cast<double>(spawned.ray.t) * d;
        const glm::dvec3 size = glm::abs(from) + glm::abs(way);
        return { side * glm::dot(normal, to - corners[0]),
            glm::distance(to, from + way) / std::max({ size.x, size.y, size.z }) };
    }

    std::string toText(const Ray& ray, const Start& start, bool meetsAgain)
    {
        return fmt::format("{}, {:.3g} {} the surface, {:.3g} of the scene away{}", exactly(ray),
            std::abs(start.height), start.height > 0.0 ? "before" : "behind", start.distance,
            meetsAgain ? ", and meets the surface again" : "");
    }

    // The ray starts on its side (1: where it came from) and does not meet the triangle again, nor does it step over
    // what is a hundredth of the scene's size away: offsets up to a thousandth are right, and some start along a ray
    // that is several times longer than high above the surface.
    bool isRight(const Start& start, double side, bool meetsAgain, const Ray& ray)
    {
        constexpr float leastEnd = 1e10f; // of a ray that is to find whatever is out there, at every scale asked
        return start.height * side > 0.0 && !meetsAgain && start.distance <= 5e-3 && ray.t >= leastEnd;
    }

    // slenderness: of the triangle whose normal the direction follows from.
    bool isTowards(const glm::vec3& came, const glm::dvec3& expected, double slenderness)
    {
        const double bound = 64.0 * rounding * slenderness; // a normal twice, a mirrored direction and its length
        return glm::distance(glm::normalize(glm::dvec3(came)), glm::normalize(expected)) <= bound;
    }

    std::string describe(const TriangleRay& input)
    {
        const auto& [v0, v1, v2] = input.triangle;
        return fmt::format("the rays that follow where {} meets {}, {}, {}", exactly(input.ray), exactly(v0),
            exactly(v1), exactly(v2));
    }

    Judgement judgeReflected(const TriangleRay& input, const Spawned& spawned)
    {
        if (!spawned.isHit)
            return right();
        const Ray& ray = spawned.reflected;
        const Start start = startOf(input, spawned, ray);
        const grading::Corners corners = grading::cornersOf(input.triangle);
        const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        const glm::dvec3 d { input.ray.direction };
        const glm::dvec3 mirrored = d - 2.0 * glm::dot(d, normal) * normal;
        const double slenderness = Crossing(input.triangle, input.ray).slenderness; // of the normal that it follows
        if (isRight(start, 1.0, spawned.reflectedMeets, ray) && isTowards(ray.direction, mirrored, slenderness))
            return right();
        return wrong(toText(ray, start, spawned.reflectedMeets),
            "a ray along " + exactly(glm::normalize(mirrored)) + " from close before the surface");
    }

    Judgement judgePassedThrough(const TriangleRay& input, const Spawned& spawned)
    {
        if (!spawned.isHit)
            return right();
        const Ray& ray = spawned.passedThrough;
        const Start start = startOf(input, spawned, ray);
        if (isRight(start, -1.0, spawned.passedThroughMeets, ray)
            && isTowards(ray.direction, glm::dvec3(input.ray.direction), 1.0))
            return right();
        return wrong(
            toText(ray, start, spawned.passedThroughMeets), "a ray that goes on from close behind the surface");
    }

    // A triangle no larger than its distance from the origin of space: the error of a hit on one that is much larger
    // than all coordinates of the hit does not follow from the ray and the hit, which are all that is known.
    TriangleRay make(Random& random, const Setting& setting)
    {
        const Frame frame = randomFrame(random);
        grading::Triangle triangle = triangleIn(frame, random, setting);
        const glm::vec3 aside = setting.size * magnitude(random, 2.0f, setting.farFromZero) * random.direction();
        triangle = { triangle.v0 + aside, triangle.v1 + aside, triangle.v2 + aside };
        return { triangle, rayTo(pointOf(triangle, weightsInside(random)), frame, random, setting) };
    }

    TriangleRay atAnyScale(Random& random)
    {
        return make(random,
            { .size = magnitude(random, 1e-6f, 1e6f),
                .slenderness = magnitude(random, 1.0f, 8.0f),
                .farFromZero = 1000.0f,
                .distance = magnitude(random, 1e-2f, 1e3f),
                .sine = random.uniform(0.1f, 1.0f) });
    }

    // Nearly along the surface, where only an offset along the normal gets off it.
    TriangleRay grazing(Random& random)
    {
        return make(random,
            { .size = magnitude(random, 1e-3f, 1e3f),
                .slenderness = 2.0f,
                .farFromZero = 10.0f,
                .distance = magnitude(random, 0.1f, 10.0f),
                .sine = magnitude(random, 1e-3f, 1e-1f) });
    }

    const Question<TriangleRay, Spawned> reflected { "stress.spawned", describe, judgeReflected };
    const Question<TriangleRay, Spawned> passedThrough { "stress.spawned", describe, judgePassedThrough };

    const Stress kinds[] {
        { "recursive.reflected.scales", reflected, randomly(400'000, atAnyScale) },
        { "recursive.reflected.grazing", reflected, randomly(200'000, grazing) },
        { "recursive.passthrough.scales", passedThrough, randomly(400'000, atAnyScale) },
        { "recursive.passthrough.grazing", passedThrough, randomly(200'000, grazing) },
    };

}
}
