#include "grading/check.h"
#include "grading/checks/recursive_ways.h"
#include "grading/expect.h"
#include "grading/picture.h"
#include <fmt/format.h>

namespace grading::recursive {
namespace {

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
        const std::vector<Incidence> incidences = incidencesAt(exam.random, cosineOfGrazing, 0.95f);
        judgeRays(exam, way, incidences, [&](const std::string& asked, const Incidence& incidence, const Ray& ray) {
            expectOffSurface(asked, way, incidence, ray);
        });
    }

    void compareReach(Exam& exam, const Way& way)
    {
        const std::vector<Incidence> incidences = incidencesAt(exam.random, cosineOfGrazing, 1.0f);
        judgeRays(exam, way, incidences, [](const std::string& asked, const Incidence&, const Ray& ray) {
            expect(ray.t >= FLT_MAX, "t of " + asked, toText(ray.t), "FLT_MAX");
        });
    }

    // Rays whose t counts in other units than a unit vector's. Only mirrored directions are to be unit again.
    void compareUnits(Exam& exam, const Way& way)
    {
        std::vector<Incidence> incidences = incidencesAt(exam.random, cosineOfGrazing, 0.95f);
        for (Incidence& incidence : incidences)
            incidence.ray.direction *= exam.random.integer(0, 1) == 0 ? 0.5f : 2.0f;
        constexpr double nearEnough = 2e-2; // where t counts in unit lengths the hit point is 0.25 off or more
        judgeRays(exam, way, incidences, [&](const std::string& asked, const Incidence& incidence, const Ray& ray) {
            if (way.side > 0.0)
                expectNear("the direction of " + asked, ray.direction, mirrored(incidence), fewRoundings);
            expectNear("the origin of " + asked, ray.origin, incidence.point(), nearEnough);
        });
    }

    // One lit surface with a colour of its own in the way of the further ray.
    Recursion recursionWith(Random& random, const Material& material, const glm::vec3& hitColor)
    {
        Recursion recursion { incidenceAt(random, cosineOfGrazing, 0.95f), hitColor, 0, random.color(), {} };
        recursion.incidence.hitInfo.material = material;
        recursion.incidence.hitInfo.material.kd = random.color();
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
        const std::string asked
            = fmt::format("{} at depth {} with ks {}, transparency {}, hitColor {} and {} along the further ray",
                way.componentFunction, recursion.rayDepth, toText(material.ks), toText(material.transparency),
                toText(recursion.hitColor), toText(glm::vec3(further)));
        const glm::dvec3 expected = way.combine(glm::dvec3(recursion.hitColor), material, further);
        expectNear(asked, answer.hitColor, expected, 4.0 * fewRoundings); // of colours of up to 4
    }

    // Materials of which each component is to use its own part alone.
    Material mirror(const glm::vec3& ks)
    {
        return { .ks = ks, .shininess = 5.0f, .transparency = 0.6f };
    }

    Material veil(float alpha)
    {
        return { .ks = { 0.2f, 0.4f, 0.7f }, .shininess = 5.0f, .transparency = alpha };
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

    // The component is judged by the submission's own ray: a mistake in that has cost its points already. A component
    // may make a ray of its own, if that is right.
    void compareRay(Exam& exam, const Way& way, const Material& material)
    {
        const Recursion recursion = recursionWith(exam.random, material, glm::vec3(0.0f));
        const auto answer = exam.ask<RecursionAnswer>(way.componentProbe, recursion);
        const std::string sender = fmt::format("{} at {}", way.componentFunction, describe(recursion.incidence));
        expect(!answer.rays.empty(), sender, "no further ray", "one");
        const Ray& sent = answer.rays[0];
        const std::string asked = "the ray sent by " + sender;
        constexpr double fewSteps = 1e-6; // of coordinates up to 3.3; a right offset is longer
        judgeRays(exam, way, { recursion.incidence }, [&](const std::string&, const Incidence& it, const Ray& own) {
            expectNear("the direction of " + asked, sent.direction, glm::dvec3(own.direction), fewRoundings);
            if (glm::distance(glm::dvec3(sent.origin), glm::dvec3(own.origin)) > fewSteps)
                expectOffSurface(asked, way, it, sent);
            expect(sent.t == own.t || sent.t >= FLT_MAX, "t of " + asked, toText(sent.t), "FLT_MAX");
        });
    }

    const Check reflectionDirection("reflection.ray.direction", 1.5,
        "the mirrored direction is d - 2 (d.n) n, or glm::reflect(d, n): d points towards the surface",
        [](Exam& exam) { compareDirection(exam, reflection, incidencesAt(exam.random, 0.01f, 1.0f)); });
    const Check reflectionUnit("reflection.ray.unit", 0.5,
        "the ray that came in need not have a unit direction: normalise the result, but not d in origin + t * d",
        [](Exam& exam) { compareUnits(exam, reflection); });
    const Check reflectionOrigin("reflection.ray.origin", 1.5,
        "start a little off the surface (1e-4, say, along the normal): without, the ray meets where it starts; much "
        "more shows",
        [](Exam& exam) { compareOrigin(exam, reflection); });
    const Check reflectionReach("reflection.ray.reach", 0.5, "the new ray has met nothing yet: its t is FLT_MAX",
        [](Exam& exam) { compareReach(exam, reflection); });
    const Check reflectionColor("reflection.light.color", 1.5,
        "each channel of what renderRay returns for the reflected ray is multiplied by that of ks", [](Exam& exam) {
            for (int i = 0; i < 10; ++i) {
                glm::vec3 ks = exam.random.color();
                if (i < 3)
                    ks[i] = 0.0f; // a mirror all the same
                Recursion recursion = recursionWith(exam.random, mirror(ks), glm::vec3(0.0f));
                recursion.rayDepth = i % 3;
                compareColor(exam, reflection, recursion);
            }
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
    const Check passthroughUnits("transparency.ray.units", 0.5,
        "the ray that came in need not have a unit direction: its t counts in units of it, as in origin + t * d",
        [](Exam& exam) { compareUnits(exam, passthrough); });
    const Check passthroughOrigin("transparency.ray.origin", 1.5,
        "start a little behind the surface: move along the ray or against the normal by 1e-4, say; a number added to "
        "all three coordinates moves towards (1, 1, 1), whichever way the ray goes",
        [](Exam& exam) { compareOrigin(exam, passthrough); });
    const Check passthroughReach("transparency.ray.reach", 0.5, "the new ray has met nothing yet: its t is FLT_MAX",
        [](Exam& exam) { compareReach(exam, passthrough); });
    const Check transparencyAlpha("transparency.light.alpha", 2.0,
        "transparency is alpha, and 1 is opaque: hitColor * alpha + behind * (1 - alpha)", [](Exam& exam) {
            for (const float alpha : { 0.2f, 0.7f, 1.0f, 0.0f, exam.random.uniform() }) {
                Recursion recursion = recursionWith(exam.random, veil(alpha), exam.random.color());
                recursion.rayDepth = exam.random.integer(0, 2);
                compareColor(exam, passthrough, recursion);
            }
        });
    const Check transparencyNothing("transparency.light.nothing", 0.5,
        "where nothing is behind, renderRay returns black: blend hitColor with that as with any other colour",
        [](Exam& exam) {
            Recursion recursion = recursionWith(exam.random, veil(0.5f), exam.random.color());
            recursion.hits.clear();
            compareColor(exam, passthrough, recursion);
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
