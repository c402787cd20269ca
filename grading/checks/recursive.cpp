#include "grading/check.h"
#include "grading/expect.h"
#include "grading/oracle/recursion.h"
#include "grading/picture.h"
#include <fmt/format.h>

namespace grading {
namespace {

    constexpr float cosineOfGrazing = 0.2f; // offsets along a ray that grazes the surface hardly leave it

    // A ray that meets a surface at a point within 3.3 of the origin, at an angle to the normal with a cosine between
    // the two.
    Incidence incidenceAt(Random& random, float minCosine, float maxCosine)
    {
        Incidence incidence;
        const glm::vec3 normal = random.direction();
        const glm::vec3 tangent = glm::normalize(glm::cross(normal, random.direction()));
        const float cosine = random.uniform(minCosine, maxCosine);
        const glm::vec3 direction = std::sqrt(1.0f - cosine * cosine) * tangent - cosine * normal;
        incidence.ray = { random.vec3(-1.0f, 1.0f), glm::normalize(direction), random.uniform(0.5f, 1.5f) };
        incidence.hitInfo.normal = normal;
        return incidence;
    }

    std::vector<Incidence> incidencesAt(Random& random, float minCosine, float maxCosine)
    {
        std::vector<Incidence> incidences;
        for (int i = 0; i < 100; ++i)
            incidences.push_back(incidenceAt(random, minCosine, maxCosine));
        return incidences;
    }

    Incidence headOn(Random& random)
    {
        Incidence incidence = incidenceAt(random, cosineOfGrazing, 1.0f);
        incidence.ray.direction = -incidence.hitInfo.normal;
        return incidence;
    }

    // One of the two ways of light that are graded.
    struct Way {
        std::string rayProbe, rayFunction;
        std::string componentProbe, componentFunction;
        glm::dvec3 (*direction)(const Incidence&); // oracle, unit
        double side; // where the new ray starts: +1 where the normal points, -1 behind the surface
        Combine combine; // oracle
    };
    const Way reflection { "recursive.reflectionRay", "generateReflectionRay", "recursive.specular",
        "renderRaySpecularComponent", mirrored, 1.0, addMirrored };
    const Way passthrough { "recursive.passthroughRay", "generatePassthroughRay", "recursive.transparent",
        "renderRayTransparentComponent", straightOn, -1.0, blendWithBehind };

    std::string describe(const Incidence& incidence)
    {
        return fmt::format("the ray from {} along {} that meets a surface with normal {} at t = {}",
            toText(incidence.ray.origin), toText(incidence.ray.direction), toText(incidence.hitInfo.normal),
            toText(incidence.ray.t));
    }

    // Calls judge(what was asked, incidence, ray) for each.
    template <typename Judge>
    void judgeRays(Exam& exam, const Way& way, const std::vector<Incidence>& incidences, const Judge& judge)
    {
        const auto rays = exam.ask<std::vector<Ray>>(way.rayProbe, incidences);
        expectCount(way.rayFunction, rays.size(), incidences.size());
        for (std::size_t i = 0; i < rays.size(); ++i)
            judge(fmt::format("{} for {}", way.rayFunction, describe(incidences[i])), incidences[i], rays[i]);
    }

    // The length is left to other checks.
    void compareDirection(Exam& exam, const Way& way, std::vector<Incidence> incidences)
    {
        incidences.push_back(headOn(exam.random));
        judgeRays(exam, way, incidences, [&](const std::string& asked, const Incidence& incidence, const Ray& ray) {
            const glm::dvec3 came = glm::normalize(glm::dvec3(ray.direction)); // NaN for a zero vector
            expectNear("the direction of " + asked, glm::vec3(came), way.direction(incidence), fewRoundings);
        });
    }

    void compareOrigin(Exam& exam, const Way& way)
    {
        // Right offsets are from 1e-5 to 1e-3. Points of up to 3.3 are rounded by 6e-7 in all: the smallest is told
        // from 1e-6, which is too small, and remains on its side of the surface by 1e-6 at least.
        constexpr double leastOffset = 5e-6;
        constexpr double mostOffset = 2e-3;
        constexpr double leastHeight = 1e-6;
        const std::vector<Incidence> incidences = incidencesAt(exam.random, cosineOfGrazing, 0.95f);
        judgeRays(exam, way, incidences, [&](const std::string& asked, const Incidence& incidence, const Ray& ray) {
            const glm::dvec3 offset = glm::dvec3(ray.origin) - incidence.point();
            const double distance = glm::length(offset);
            const double height = glm::dot(offset, glm::dvec3(incidence.hitInfo.normal));
            const bool isNear = distance >= leastOffset && distance <= mostOffset;
            expect(isNear && height * way.side >= leastHeight, "the origin of " + asked,
                fmt::format("{}, which is {:.1e} from the hit point and {:.1e} {} the surface", toText(ray.origin),
                    distance, std::abs(height), height < 0.0 ? "behind" : "in front of"),
                fmt::format("the hit point {}, moved by 1e-5 to 1e-3 to where it is {} the surface",
                    toText(glm::vec3(incidence.point())), way.side < 0.0 ? "behind" : "in front of"));
        });
    }

    void compareReach(Exam& exam, const Way& way)
    {
        const std::vector<Incidence> incidences = incidencesAt(exam.random, cosineOfGrazing, 1.0f);
        judgeRays(exam, way, incidences, [](const std::string& asked, const Incidence&, const Ray& ray) {
            expect(ray.t >= FLT_MAX, "t of " + asked, toText(ray.t), "FLT_MAX");
        });
    }

    // Rays whose t counts in other units than a unit vector's.
    void compareUnit(Exam& exam)
    {
        std::vector<Incidence> incidences = incidencesAt(exam.random, cosineOfGrazing, 0.95f);
        for (Incidence& incidence : incidences)
            incidence.ray.direction *= exam.random.integer(0, 1) == 0 ? 0.5f : 2.0f;
        constexpr double nearEnough = 2e-2; // where t counts in unit lengths the hit point is 0.25 off or more
        judgeRays(
            exam, reflection, incidences, [](const std::string& asked, const Incidence& incidence, const Ray& ray) {
                expectNear("the direction of " + asked, ray.direction, mirrored(incidence), fewRoundings);
                expectNear("the origin of " + asked, ray.origin, incidence.point(), nearEnough);
            });
    }

    // One lit surface with a colour of its own in the way of the further ray.
    Recursion recursionWith(Random& random, const Material& material, const glm::vec3& hitColor)
    {
        Recursion recursion { incidenceAt(random, cosineOfGrazing, 0.95f), hitColor, 0, random.color(), {} };
        recursion.incidence.hitInfo.material = material;
        recursion.hits.push_back({ random.direction(), random.uniform(0.5f, 1.5f), { .kd = random.color() } });
        return recursion;
    }

    // The further ray meets this many more surfaces of the same material.
    void putInTheWay(Random& random, Recursion& recursion, int count)
    {
        for (int i = 0; i < count; ++i) {
            ScriptedHit hit { random.direction(), random.uniform(0.5f, 1.5f), recursion.incidence.hitInfo.material };
            hit.material.kd = random.color();
            recursion.hits.insert(recursion.hits.begin(), hit);
        }
    }

    void compareColor(Exam& exam, const Way& way, const Recursion& recursion)
    {
        const auto answer = exam.ask<RecursionAnswer>(way.componentProbe, recursion);
        const Material& material = recursion.incidence.hitInfo.material;
        const glm::dvec3 further = lightFrom(recursion, way.combine);
        const std::string asked = fmt::format(
            "{} with ks {}, transparency {}, hitColor {} and {} along the further ray", way.componentFunction,
            toText(material.ks), toText(material.transparency), toText(recursion.hitColor), toText(glm::vec3(further)));
        const glm::dvec3 expected = way.combine(glm::dvec3(recursion.hitColor), material, further);
        expectNear(asked, answer.hitColor, expected, 4.0 * fewRoundings); // of colours of up to 4
    }

    Material mirror(const glm::vec3& ks)
    {
        return { .ks = ks };
    }

    Material veil(float alpha)
    {
        return { .transparency = alpha };
    }

    // renderRay goes on below depth 6: from depth d come 6 - d further rays if each is one deeper than the last.
    void compareDepth(Exam& exam, const Way& way, const Material& material)
    {
        for (int depth = 0; depth < 6; ++depth) {
            Recursion recursion = recursionWith(exam.random, material, glm::vec3(0.0f));
            recursion.rayDepth = depth;
            putInTheWay(exam.random, recursion, 20);
            const auto answer = exam.ask<RecursionAnswer>(way.componentProbe, recursion);
            expect(answer.rays.size() == static_cast<std::size_t>(6 - depth),
                fmt::format(
                    "{} with rayDepth {} where every surface sends a further ray", way.componentFunction, depth),
                fmt::format("{} rays", answer.rays.size()), fmt::format("{}", 6 - depth));
        }
    }

    // The component is judged by the submission's own ray: a mistake in that has cost its points already.
    void compareRay(Exam& exam, const Way& way, const Material& material)
    {
        const Recursion recursion = recursionWith(exam.random, material, glm::vec3(0.0f));
        const auto answer = exam.ask<RecursionAnswer>(way.componentProbe, recursion);
        const std::string asked = fmt::format("{} at {}", way.componentFunction, describe(recursion.incidence));
        expect(!answer.rays.empty(), asked, "no further ray", "one");
        constexpr double nearEnough = 5e-3; // for two offsets of different kinds
        judgeRays(exam, way, { recursion.incidence }, [&](const std::string&, const Incidence&, const Ray& ray) {
            expectNear("the direction of the ray sent by " + asked, answer.rays[0].direction, glm::dvec3(ray.direction),
                fewRoundings);
            expectNear(
                "the origin of the ray sent by " + asked, answer.rays[0].origin, glm::dvec3(ray.origin), nearEnough);
        });
    }

    const Check reflectionDirection("reflection.ray.direction", 1.5,
        "the mirrored direction is d - 2 (d.n) n, or glm::reflect(d, n): d points towards the surface",
        [](Exam& exam) { compareDirection(exam, reflection, incidencesAt(exam.random, 0.01f, 1.0f)); });
    const Check reflectionUnit("reflection.ray.unit", 0.5,
        "the ray that came in need not have a unit direction: normalise the result, but not d in origin + t * d",
        compareUnit);
    const Check reflectionOrigin("reflection.ray.origin", 1.5,
        "start a little off the surface (1e-4, say, along the normal): without, the ray meets where it starts; much "
        "more shows",
        [](Exam& exam) { compareOrigin(exam, reflection); });
    const Check reflectionReach("reflection.ray.reach", 0.5, "the new ray has met nothing yet: its t is FLT_MAX",
        [](Exam& exam) { compareReach(exam, reflection); });
    const Check reflectionColor("reflection.light.color", 1.5,
        "each channel of what renderRay returns for the reflected ray is multiplied by that of ks", [](Exam& exam) {
            for (int i = 0; i < 10; ++i)
                compareColor(
                    exam, reflection, recursionWith(exam.random, mirror(exam.random.color()), glm::vec3(0.0f)));
        });
    const Check reflectionAdded("reflection.light.added", 1.0,
        "the mirrored light comes on top of hitColor: += rather than = or a blend", [](Exam& exam) {
            // ks = 1, and dark enough that a clamp does not show: other mistakes have checks of their own.
            Recursion recursion = recursionWith(exam.random, mirror(glm::vec3(1.0f)), exam.random.vec3(0.1f, 0.3f));
            recursion.light *= 0.5f;
            compareColor(exam, reflection, recursion);
            recursion.hits.clear();
            compareColor(exam, reflection, recursion);
        });
    const Check reflectionUnclamped("reflection.light.unclamped", 0.5,
        "colours above 1 stay as they are: they are clamped when the picture is written", [](Exam& exam) {
            Recursion recursion = recursionWith(exam.random, mirror(glm::vec3(1.0f)), glm::vec3(0.0f));
            recursion.light = exam.random.vec3(2.0f, 4.0f) / recursion.hits[0].material.kd;
            compareColor(exam, reflection, recursion);
        });
    const Check reflectionDepth("reflection.light.depth", 1.0,
        "pass rayDepth + 1 to renderRay: facing mirrors never end",
        [](Exam& exam) { compareDepth(exam, reflection, mirror(exam.random.color())); });
    const Check reflectionRay("reflection.light.ray", 1.0, "renderRay gets the ray of generateReflectionRay",
        [](Exam& exam) { compareRay(exam, reflection, mirror(exam.random.color())); });
    const Check reflectionPicture("reflection.picture.mirrors", 1.0, "see the other checks of reflections",
        [](Exam& exam) { comparePicture(exam, pictureOf("reflections")); });

    const Check passthroughDirection("transparency.ray.direction", 1.0, "the ray goes on in the direction it came in",
        [](Exam& exam) { compareDirection(exam, passthrough, incidencesAt(exam.random, 0.01f, 1.0f)); });
    const Check passthroughOrigin("transparency.ray.origin", 2.0,
        "start a little behind the surface: move along the ray or against the normal by 1e-4, say; a number added to "
        "all three coordinates moves towards (1, 1, 1), whichever way the ray goes",
        [](Exam& exam) { compareOrigin(exam, passthrough); });
    const Check passthroughReach("transparency.ray.reach", 0.5, "the new ray has met nothing yet: its t is FLT_MAX",
        [](Exam& exam) { compareReach(exam, passthrough); });
    const Check transparencyAlpha("transparency.light.alpha", 2.5,
        "transparency is alpha, and 1 is opaque: hitColor * alpha + behind * (1 - alpha)", [](Exam& exam) {
            for (const float alpha : { 0.2f, 0.7f, 1.0f, 0.0f, exam.random.uniform() })
                compareColor(exam, passthrough, recursionWith(exam.random, veil(alpha), exam.random.color()));
        });
    const Check transparencyLayers("transparency.light.layers", 1.0,
        "each layer is blended with all that lies behind it, by renderRay, not with the next surface alone",
        [](Exam& exam) {
            // Half and half: alpha may be the wrong way round, which has a check of its own.
            Recursion recursion = recursionWith(exam.random, veil(0.5f), exam.random.color());
            putInTheWay(exam.random, recursion, 4);
            compareColor(exam, passthrough, recursion);
        });
    const Check transparencyUnclamped("transparency.light.unclamped", 0.5,
        "colours above 1 stay as they are: they are clamped when the picture is written", [](Exam& exam) {
            Recursion recursion = recursionWith(exam.random, veil(0.5f), exam.random.vec3(2.0f, 4.0f));
            recursion.light = exam.random.vec3(2.0f, 4.0f) / recursion.hits[0].material.kd;
            compareColor(exam, passthrough, recursion);
        });
    const Check transparencyDepth("transparency.light.depth", 1.0, "pass rayDepth + 1 to renderRay",
        [](Exam& exam) { compareDepth(exam, passthrough, veil(0.5f)); });
    const Check transparencyRay("transparency.light.ray", 0.5, "renderRay gets the ray of generatePassthroughRay",
        [](Exam& exam) { compareRay(exam, passthrough, veil(0.5f)); });
    const Check transparencyPicture("transparency.picture.layers", 1.0, "see the other checks of transparency",
        [](Exam& exam) { comparePicture(exam, pictureOf("transparency")); });

}
}
