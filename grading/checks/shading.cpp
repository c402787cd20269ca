#include "shading.h"
#include "grading/check.h"
#include "grading/expect.h"
#include "grading/picture.h"
#include "grading/probes/shading_case.h"
#include <fmt/format.h>

namespace grading::shading {
namespace {

    using Component = LinearGradient::Component;
    using Components = std::vector<Component>;

    // Components at distinct positions, a tenth apart or more, in random order.
    Components randomComponents(Random& random)
    {
        Components components;
        for (float t = random.uniform(-0.9f, -0.6f); t < 0.9f; t += random.uniform(0.1f, 0.6f))
            components.push_back({ t, random.color() });
        for (std::size_t i = components.size(); i > 1; --i)
            std::swap(
                components[i - 1], components[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
        if (components.front().t < components.back().t) // never sorted by chance
            std::swap(components.front(), components.back());
        return components;
    }

    glm::dvec3 gradientOracle(Components components, double t)
    {
        std::sort(components.begin(), components.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
        if (t <= static_cast<double>(components.front().t))
            return components.front().color;
        for (std::size_t i = 1; i < components.size(); ++i) {
            const auto& [t0, color0] = components[i - 1];
            const auto& [t1, color1] = components[i];
            if (t <= static_cast<double>(t1)) {
                const double weight
                    = (t - static_cast<double>(t0)) / (static_cast<double>(t1) - static_cast<double>(t0));
                return glm::dvec3(color0) * (1.0 - weight) + glm::dvec3(color1) * weight;
            }
        }
        return components.back().color;
    }

    std::string asked(const Components& components, float t)
    {
        return fmt::format("LinearGradient::sample({:.4g}) of {} components", t, components.size());
    }

    std::vector<glm::vec3> sample(Exam& exam, const Components& components, const std::vector<float>& positions)
    {
        auto colors = exam.ask<std::vector<glm::vec3>>("shading.gradient", components, positions);
        expectCount("LinearGradient::sample", colors.size(), positions.size());
        return colors;
    }

    void compareSamples(Exam& exam, float lower, float upper)
    {
        for (int i = 0; i < 20; ++i) {
            const Components components = randomComponents(exam.random);
            std::vector<float> positions;
            for (int k = 0; k < 20; ++k)
                positions.push_back(exam.random.uniform(lower, upper));
            const std::vector<glm::vec3> colors = sample(exam, components, positions);
            for (std::size_t k = 0; k < positions.size(); ++k)
                expectNear(asked(components, positions[k]), colors[k],
                    gradientOracle(components, static_cast<double>(positions[k])), fewRoundings);
        }
    }

    const Check between("shading.gradient.between", 2.0,
        "the components may come unsorted: find the closest at or below ti and the closest at or above it",
        [](Exam& exam) { compareSamples(exam, -0.6f, 0.3f); });

    const Check ends("shading.gradient.ends", 1.0,
        "below the first component or above the last, the nearest component's colour is meant", [](Exam& exam) {
            compareSamples(exam, -1.0f, -0.9f);
            compareSamples(exam, 0.9f, 1.0f);
        });

    bool isNear(const glm::vec3& a, const glm::dvec3& b)
    {
        return glm::distance(glm::dvec3(a), b) <= fewRoundings;
    }

    void expectEither(const std::string& asked, const glm::vec3& came, const glm::dvec3& a, const glm::dvec3& b)
    {
        expect(isNear(came, a) || isNear(came, b), asked, toText(came),
            toText(glm::vec3(a)) + " or " + toText(glm::vec3(b)));
    }

    // At the components' positions and between, with one more component at the position of another: whichever of the
    // two counts, the colour is that of the gradient without the other.
    void compareShared(Exam& exam, Components components)
    {
        const Components withoutSecond = components;
        const int first = exam.random.integer(0, static_cast<int>(components.size()) - 1);
        components.push_back({ components[static_cast<std::size_t>(first)].t, exam.random.color() });
        Components withoutFirst = components;
        withoutFirst.erase(withoutFirst.begin() + first);

        std::vector<float> positions;
        for (const Component& component : withoutSecond)
            positions.push_back(component.t);
        for (int i = 0; i < 20; ++i)
            positions.push_back(exam.random.uniform(-1.0f, 1.0f));
        const std::vector<glm::vec3> colors = sample(exam, components, positions);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const auto t = static_cast<double>(positions[i]);
            expectEither(asked(components, positions[i]) + ", two of them at the same position", colors[i],
                gradientOracle(withoutFirst, t), gradientOracle(withoutSecond, t));
        }
    }

    const Check equal("shading.gradient.equal", 0.5,
        "at a component's position, and where two have the same, the gap is 0, and 0 / 0 is NaN", [](Exam& exam) {
            for (const float position : { -0.7f, 0.0f, 0.25f, 0.8f })
                compareShared(exam, { { position, exam.random.color() } });
            for (int i = 0; i < 20; ++i)
                compareShared(exam, randomComponents(exam.random));
        });

    const Check few("shading.gradient.few", 0.5,
        "with one component every position has its colour; with none the colour is black", [](Exam& exam) {
            const Components one { { 0.2f, exam.random.color() } };
            for (const glm::vec3& color : sample(exam, one, { -1.0f, 0.2f, 1.0f }))
                expectNear("LinearGradient::sample of one component", color, one[0].color, fewRoundings);
            expectNear(
                "LinearGradient::sample without components", sample(exam, {}, { 0.0f }).front(), glm::dvec3(0.0), 0.0);
        });

    double cosineOf(const ShadingCase& c)
    {
        return glm::clamp(glm::dot(glm::dvec3(c.normal), glm::dvec3(c.lightDirection)), -1.0, 1.0);
    }

    // Points with the light in front of them, or behind.
    std::vector<ShadingCase> randomCases(Random& random, bool inFront, const glm::vec3& lightColor)
    {
        std::vector<ShadingCase> cases;
        while (cases.size() < 100) {
            ShadingCase c { random.direction(), random.direction(), lightColor, random.direction() };
            if ((cosineOf(c) > 0.0) == inFront)
                cases.push_back(c);
        }
        return cases;
    }

    // The course left open whether the colour is multiplied by max(cosine, 0): all with or all without.
    void compareModel(Exam& exam, const std::vector<ShadingCase>& cases)
    {
        const Components components = randomComponents(exam.random);
        const auto colors = exam.ask<std::vector<glm::vec3>>("shading.model", components, cases);
        expectCount("computeLinearGradientModel", colors.size(), cases.size());
        const auto expected = [&](std::size_t i, bool withCosine) {
            const double factor = withCosine ? std::max(cosineOf(cases[i]), 0.0) : 1.0;
            return glm::dvec3(cases[i].lightColor) * gradientOracle(components, cosineOf(cases[i])) * factor;
        };
        bool allWithCosine = true;
        for (std::size_t i = 0; i < cases.size(); ++i)
            allWithCosine &= glm::length(glm::dvec3(colors[i]) - expected(i, true)) <= fewRoundings;
        for (std::size_t i = 0; i < cases.size() && !allWithCosine; ++i)
            expectNear(fmt::format("computeLinearGradientModel at a cosine of {:.4g}, light colour {}",
                           cosineOf(cases[i]), toText(cases[i].lightColor)),
                colors[i], expected(i, false), fewRoundings);
    }

    const Check cosine("shading.model.cosine", 1.5,
        "the position in the gradient is the cosine itself, dot(normal, light), not mapped to [0, 1]; no specular term",
        [](Exam& exam) { compareModel(exam, randomCases(exam.random, true, glm::vec3(1.0f))); });
    const Check lightColor("shading.model.light_color", 1.0, "the gradient's colour is multiplied by lightColor",
        [](Exam& exam) { compareModel(exam, randomCases(exam.random, true, 2.0f * exam.random.color())); });
    const Check behind("shading.model.behind", 0.5,
        "a light behind the surface has a negative cosine: the lower half of the gradient, or black; never negative "
        "light",
        [](Exam& exam) { compareModel(exam, randomCases(exam.random, false, glm::vec3(1.0f))); });

    // Red below 0, green at 0, blue above: tells on which side of 0 a colour was taken.
    const Components sides { { -1.0f, { 1, 0, 0 } }, { 0.0f, { 0, 1, 0 } }, { 1.0f, { 0, 0, 1 } } };

    struct Lobes {
        double phong, blinnPhong; // the cosines that are raised to the shininess
    };

    Lobes lobesOf(const ShadingCase& c)
    {
        const glm::dvec3 n(c.normal), l(c.lightDirection), v(c.cameraDirection);
        return { std::max(glm::dot(2.0 * glm::dot(n, l) * n - l, v), 0.0),
            std::max(glm::dot(n, glm::normalize(l + v)), 0.0) };
    }

    // Phong's specular term minus Blinn-Phong's.
    double lobeDifference(const ShadingCase& c)
    {
        const auto [phong, blinnPhong] = lobesOf(c);
        const auto shininess = static_cast<double>(c.shininess);
        return std::pow(phong, shininess) - std::pow(blinnPhong, shininess);
    }

    // Points that both the light and the camera are in front of, where one model is brighter by a fiftieth or more.
    ShadingCase decidedCase(Random& random, bool phongIsBrighter)
    {
        for (;;) {
            ShadingCase c { random.direction(), random.direction(), glm::vec3(1.0f), random.direction() };
            c.shininess = random.uniform(1.0f, 4.0f);
            const double difference = lobeDifference(c) * (phongIsBrighter ? 1.0 : -1.0);
            if (glm::dot(c.normal, c.cameraDirection) > 0.02f && cosineOf(c) > 0.02 && difference > 0.02)
                return c;
        }
    }

    const Check comparisonSign("shading.comparison.sign", 1.5,
        "the difference must keep its sign: a length is never negative, and half of the gradient is out of reach",
        [](Exam& exam) {
            std::vector<ShadingCase> cases;
            for (int i = 0; i < 400; ++i)
                cases.push_back(decidedCase(exam.random, i % 2 == 0));
            const auto colors = exam.ask<std::vector<glm::vec3>>("shading.comparison", sides, cases);
            expectCount("computeLinearGradientModelComparison", colors.size(), cases.size());
            const bool phongIsRed = colors[0].r > colors[0].b; // which side is whose is free, but it is one side
            for (std::size_t i = 0; i < cases.size(); ++i) {
                const bool wantsRed = phongIsRed == (i % 2 == 0);
                const bool isRed = colors[i].r > 0.0f && !(colors[i].b > 0.0f);
                const bool isBlue = colors[i].b > 0.0f && !(colors[i].r > 0.0f);
                expect(wantsRed ? isRed : isBlue,
                    fmt::format("computeLinearGradientModelComparison where {} is brighter by {:.3f}",
                        i % 2 == 0 ? "Phong" : "Blinn-Phong", std::abs(lobeDifference(cases[i]))),
                    toText(colors[i]) + " from a gradient red below 0, blue above",
                    wantsRed ? "a colour from below 0" : "a colour from above 0");
            }
        });

    // A surface so shiny that both terms are 0: 0.99 to this power is.
    ShadingCase narrowCase(Random& random)
    {
        for (int i = 0;; ++i) {
            ShadingCase c = decidedCase(random, i % 2 == 0);
            c.shininess = 1e5f;
            if (std::max(lobesOf(c).phong, lobesOf(c).blinnPhong) < 0.99)
                return c;
        }
    }

    // Green alone. Black as well where black says that the factor max(cosine, 0) is in it, which was left open.
    void expectMiddle(const std::vector<glm::vec3>& colors, bool isBehind)
    {
        for (const glm::vec3& color : colors) {
            const bool isGreen = isBehind ? color.g >= 0.0f : color.g > 0.0f;
            // A rounding of the lobes is raised to the 5th power.
            const bool isGreenAlone
                = isGreen && std::abs(color.r) <= 10.0 * fewRoundings && std::abs(color.b) <= 10.0 * fewRoundings;
            expect(isGreenAlone, "computeLinearGradientModelComparison where both are equal",
                toText(color) + " from a gradient red below 0, green at 0, blue above", "green");
        }
    }

    const Check comparisonEqual("shading.comparison.equal", 0.5,
        "where both models give the same, the position in the gradient is 0: both shine fully, not at all, or the "
        "light is behind; light = -view has no halfway vector: NaN",
        [](Exam& exam) {
            std::vector<ShadingCase> full, none, unlit;
            for (int i = 0; i < 50; ++i) {
                const glm::vec3 n = exam.random.direction();
                full.push_back({ n, n, glm::vec3(1.0f), n, glm::vec3(0.5f), glm::vec3(1.0f), 5.0f });
                none.push_back(narrowCase(exam.random));
                unlit.push_back({ n, -n, glm::vec3(1.0f), n });
            }
            for (const auto& cases : { full, none, unlit }) {
                const auto colors = exam.ask<std::vector<glm::vec3>>("shading.comparison", sides, cases);
                expectCount("computeLinearGradientModelComparison", colors.size(), cases.size());
                expectMiddle(colors, cosineOf(cases.front()) < 0.0);
            }
        });

    // A gradient that the check brings along, whatever stands in the student's computeShading; the model with or
    // without the course's optional factor.
    const Components rainbow { { 0.4f, { 0.9f, 0.7f, 0.1f } }, { -0.8f, { 0.1f, 0.2f, 0.6f } },
        { 0.9f, { 0.8f, 0.15f, 0.3f } }, { -0.1f, { 0.2f, 0.7f, 0.4f } } };

    const Check picture(
        "shading.picture.gradient", 1.0, "see the checks of computeLinearGradientModel", [](Exam& exam) {
            const auto question = [](bool withCosine) {
                PictureQuestion asked = pictureOf("gradient");
                asked.probe = "shading.replicates";
                asked.more << rainbow << withCosine;
                return asked;
            };
            comparePicture(exam, question(false), { question(false), question(true) });
        });

}
}
