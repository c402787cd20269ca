#include "grading/stress/probes/models.h"
#include "grading/stress/rounding.h"
#include "grading/stress/shading_inputs.h"
#include "grading/stress/stress.h"
#include <cfloat>

namespace stress::shading_gradient_model {
namespace {

    using grading::ShadingCase;

    std::string describeModel(const ShadingCase& c)
    {
        return "computeLinearGradientModel: " + describe(c);
    }

    std::string describeComparison(const ShadingCase& c)
    {
        return "computeLinearGradientModelComparison: " + describe(c);
    }

    std::string describePair(const Comparisons& pair)
    {
        return describeComparison(pair.phongIsBrighter) + "; and " + describe(pair.blinnPhongIsBrighter);
    }

    double cosineOf(const ShadingCase& c)
    {
        return std::clamp(glm::dot(glm::dvec3(c.normal), glm::dvec3(c.lightDirection)), -1.0, 1.0);
    }

    glm::dvec3 gentleColor(double t)
    {
        auto components = gentleGradient.components;
        std::sort(components.begin(), components.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
        std::size_t i = 1;
        while (i + 1 < components.size() && t > static_cast<double>(components[i].t))
            ++i;
        const auto &below = components[i - 1], &above = components[i];
        const double gap = static_cast<double>(above.t) - static_cast<double>(below.t);
        return glm::mix(glm::dvec3(below.color), glm::dvec3(above.color), (t - static_cast<double>(below.t)) / gap);
    }

    // The cosine is rounded by two ulps, the colour by as many as a blend. The course left open whether the colour is
    // multiplied by max(cosine, 0).
    Judgement judgeModel(const ShadingCase& c, const glm::vec3& came)
    {
        const glm::dvec3 light(c.lightColor);
        const glm::dvec3 color = light * gentleColor(cosineOf(c));
        const Judgement judgement = judgeUlps(came, color, light, 8.0);
        const bool withCosine = ulpsBetween(came, color * std::max(cosineOf(c), 0.0), light) <= 8.0;
        return withCosine ? right() : judgement;
    }

    // Whatever the difference is: from between the colours, whose channels add up to 1.
    Judgement judgeComparison(const ShadingCase& c, const glm::vec3& came)
    {
        const Judgement judgement
            = judgeInside(came, glm::dvec3(0.0), glm::dvec3(c.lightColor) * (1.0 + 4.0 * ulpOfOne));
        const double cosine = cosineOf(c);
        const bool hasHalfway = glm::length(glm::dvec3(c.lightDirection) + glm::dvec3(c.cameraDirection)) > ulpOfOne;
        const bool isUndecided = std::abs(cosine) <= 4.0 * ulpOfOne || !hasHalfway;
        const bool areEqual = cosine < 0.0 || c.shininess == 0.0f; // both dark, or both are something to the 0th
        const float side = std::max(came.r, came.b);
        if (judgement.isRight && areEqual && !isUndecided && !(side <= 4.0 * ulpOfOne * came.g))
            return wrong(exactly(came), "the colour at 0: neither model has a brighter highlight");
        return judgement;
    }

    // Which half of the gradient is whose is left open, but they are two.
    Judgement judgePair(const Comparisons&, const ComparisonColors& came)
    {
        const auto sideOf = [](const glm::vec3& color) { return (color.r > 0.0f ? -1 : 0) + (color.b > 0.0f ? 1 : 0); };
        if (sideOf(came.phongIsBrighter) * sideOf(came.blinnPhongIsBrighter) == -1)
            return right();
        return wrong(fmt::format("{} and {}", exactly(came.phongIsBrighter), exactly(came.blinnPhongIsBrighter)),
            "one from below 0, one from above");
    }

    const Question<ShadingCase, glm::vec3> model { "stress.gradient_model", describeModel, judgeModel };
    const Question<ShadingCase, glm::vec3> comparison { "stress.comparison", describeComparison, judgeComparison };
    const Question<Comparisons, ComparisonColors> pair { "stress.comparisons", describePair, judgePair };

    const Stress modelAnywhere("gradient.model.anywhere", model, randomly<ShadingCase>(300'000, anyCase));
    const Stress modelSpecial("gradient.model.special", model, constructed<ShadingCase>(specialCases()));
    const Stress comparisonAnywhere(
        "gradient.comparison.anywhere", comparison, randomly<ShadingCase>(300'000, anyCase));
    const Stress comparisonSpecial("gradient.comparison.special", comparison, constructed<ShadingCase>(specialCases()));
    const Stress sides("gradient.comparison.sides", pair, randomly<Comparisons>(5'000, [](Random& random) {
        const ShadingCase phongIsBrighter = decidedCase(random, true);
        return Comparisons { phongIsBrighter, decidedCase(random, false) };
    }));

}
}
