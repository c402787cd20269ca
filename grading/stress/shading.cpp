#include "grading/stress/probes/models.h"
#include "grading/stress/rounding.h"
#include "grading/stress/shading_inputs.h"
#include "grading/stress/stress.h"
#include <cfloat>

// The provided models. A rounding of a cosine is raised to the shininess: what is right is an interval.
namespace stress::shading {
namespace {

    using grading::ShadingCase;

    std::string describeModels(const ShadingCase& c)
    {
        return "the provided models: " + describe(c);
    }

    struct Interval {
        double lower, upper;
    };

    // Three products and two sums of numbers whose sizes add up to 1, rounded by 2^-24 each.
    constexpr double roundedCosine = 2.0 * ulpOfOne;
    // The mirrored vector is rounded first, by up to three times as much; the halfway vector by less.
    constexpr double roundedLobe = 8.0 * ulpOfOne;

    Interval around(double cosine, double rounded)
    {
        return { std::clamp(cosine - rounded, 0.0, 1.0), std::clamp(cosine + rounded, 0.0, 1.0) };
    }

    Interval raised(const Interval& cosines, double shininess)
    {
        return { std::pow(cosines.lower, shininess), std::pow(cosines.upper, shininess) };
    }

    Interval phongLobe(const ShadingCase& c)
    {
        const glm::dvec3 n(c.normal), l(c.lightDirection), v(c.cameraDirection);
        const double cosine = glm::dot(2.0 * glm::dot(n, l) * n - l, v);
        return raised(around(cosine, roundedLobe), static_cast<double>(c.shininess));
    }

    Interval blinnPhongLobe(const ShadingCase& c)
    {
        const glm::dvec3 n(c.normal), l(c.lightDirection), v(c.cameraDirection);
        const double length = glm::length(l + v);
        if (length < 1e-18) // its square is no float: there is no halfway vector, or there is
            return { 0.0, 1.0 };
        return raised(around(glm::dot(n, (l + v) / length), roundedLobe), static_cast<double>(c.shininess));
    }

    // light * (kd * cosine + ks * lobe), and nothing of a light behind the surface.
    Judgement judgeModel(const ShadingCase& c, const glm::vec3& came, const Interval& lobe)
    {
        const double cosine = glm::dot(glm::dvec3(c.normal), glm::dvec3(c.lightDirection));
        const glm::dvec3 light(c.lightColor), kd(c.kd), ks(c.ks);
        const bool mayBeBehind = cosine <= roundedCosine;
        const bool mayBeInFront = cosine >= -roundedCosine;
        // Of vectors whose lengths are rounded it may be above 1, and be cut off there.
        const Interval diffuse { std::clamp(cosine - roundedCosine, 0.0, 1.0), cosine + roundedCosine };
        const glm::dvec3 darkest = mayBeBehind ? glm::dvec3(0.0) : light * (kd * diffuse.lower + ks * lobe.lower);
        const glm::dvec3 brightest = mayBeInFront ? light * (kd * diffuse.upper + ks * lobe.upper) : glm::dvec3(0.0);
        for (int i = 0; i < 3; ++i) {
            const double few = 4.0 * ulpOfOne; // roundings of products, one sum and the power
            const double lost = 4.0 * leastFloat * (1.0 + light[i]); // by underflow, before it is multiplied
            const double upper = brightest[i] * (1.0 + few) + lost;
            const auto value = static_cast<double>(came[i]);
            if (value >= darkest[i] * (1.0 - few) - lost && value >= 0.0 && (value <= upper || upper > FLT_MAX))
                continue;
            return wrong(exactly(came), fmt::format("from {} to {}", exactly(darkest), exactly(brightest)));
        }
        return right();
    }

    Judgement judge(const ShadingCase& c, const Models& came)
    {
        for (const Judgement& judgement : { judgeModel(c, came.lambertian, { 0.0, 0.0 }),
                 judgeModel(c, came.phong, phongLobe(c)), judgeModel(c, came.blinnPhong, blinnPhongLobe(c)) })
            if (!judgement.isRight)
                return judgement;
        return right();
    }

    const Question<ShadingCase, Models> models { "stress.models", describeModels, judge };

    const Stress anywhere("shading.models.anywhere", models, randomly<ShadingCase>(600'000, anyCase));
    const Stress special("shading.models.special", models, constructed<ShadingCase>(specialCases()));

}
}
