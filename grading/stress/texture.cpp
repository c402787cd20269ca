#include "grading/stress/probes/lookup.h"
#include "grading/stress/rounding.h"
#include "grading/stress/stress.h"
#include "grading/stress/texture_inputs.h"

// Each lookup against the texels' numbers, in double precision: the product of a coordinate and a size is exact there.
namespace stress::texture {
namespace {

    std::string describe(const Lookup& lookup)
    {
        return fmt::format("{} x {} texels at {}", lookup.size.x, lookup.size.y, exactly(lookup.texCoord));
    }

    std::string describeNearest(const Lookup& lookup)
    {
        return "sampleTextureNearest of " + describe(lookup);
    }

    std::string describeBilinear(const Lookup& lookup)
    {
        return "sampleTextureBilinear of " + describe(lookup);
    }

    std::string describeStep(const Step& step)
    {
        return fmt::format(
            "sampleTextureBilinear of {}, and of the next {}", describe(step.lookup), step.axis == 0 ? 'u' : 'v');
    }

    glm::dvec3 texel(const glm::ivec2& size, const glm::ivec2& at)
    {
        return glm::dvec3(grading::colorOf(texelsOf(size), at.y * size.x + at.x)) / 255.0;
    }

    // In texels along one axis, where there are size of them.
    struct Place {
        double x;
        double rounded; // how far off x a right function may be: the product is rounded, and what is made of it
        int size;

        [[nodiscard]] int texelAt(double offset) const
        {
            return static_cast<int>(std::clamp(std::floor(x + offset), 0.0, size - 1.0));
        }
    };

    Place placeOf(const Lookup& lookup, int axis)
    {
        const double x = static_cast<double>(lookup.texCoord[axis]) * lookup.size[axis];
        return { x, ulpOfOne * std::min(std::abs(x), 2.0 * lookup.size[axis]), lookup.size[axis] };
    }

    // The texels that a coordinate may mean: two where a border is within its rounding, any for NaN.
    std::pair<int, int> texelsAt(const Place& place)
    {
        if (std::isnan(place.x))
            return { 0, place.size - 1 };
        return { place.texelAt(-place.rounded), place.texelAt(place.rounded) };
    }

    Judgement judgeNearest(const Lookup& lookup, const glm::vec3& came)
    {
        const auto [left, right_] = texelsAt(placeOf(lookup, 0));
        const auto [lower, upper] = texelsAt(placeOf(lookup, 1));
        Judgement judgement;
        for (int j = lower; j <= upper; ++j) {
            for (int i = left; i <= right_; ++i) {
                judgement = judgeUlps(came, texel(lookup.size, { i, j }), glm::dvec3(1.0), 1.0);
                if (judgement.isRight)
                    return judgement;
            }
        }
        return judgement;
    }

    glm::dvec3 bilinearOracle(const Lookup& lookup)
    {
        glm::ivec2 first, second;
        glm::dvec2 weight;
        for (int axis = 0; axis < 2; ++axis) {
            const double last = lookup.size[axis] - 1.0;
            const double x = std::clamp(placeOf(lookup, axis).x - 0.5, 0.0, last);
            first[axis] = static_cast<int>(x);
            second[axis] = std::min(first[axis] + 1, lookup.size[axis] - 1);
            weight[axis] = x - first[axis];
        }
        const auto at = [&](int i, int j) { return texel(lookup.size, { i, j }); };
        return glm::mix(glm::mix(at(first.x, first.y), at(second.x, first.y), weight.x),
            glm::mix(at(first.x, second.y), at(second.x, second.y), weight.x), weight.y);
    }

    // Colours of neighbours differ by up to 1: they are off by as much as the place is, in each direction.
    double sensitivity(const Lookup& lookup)
    {
        const glm::dvec2 place = glm::min(glm::abs(glm::dvec2(lookup.texCoord)), 2.0) * glm::dvec2(lookup.size);
        return 1.0 + place.x + place.y;
    }

    Judgement judgeBilinear(const Lookup& lookup, const glm::vec3& came)
    {
        if (glm::any(glm::isnan(lookup.texCoord)))
            return judgeInside(came, glm::dvec3(0.0), glm::dvec3(1.0 + ulpOfOne)); // any texels
        // The place is rounded twice, by half an ulp of it; three blends are rounded four times each.
        return judgeUlps(came, bilinearOracle(lookup), glm::dvec3(sensitivity(lookup)), 6.0);
    }

    // With powers of two nothing is rounded on the way to a centre: the weights are 1 and 0.
    Judgement judgeCentre(const Lookup& lookup, const glm::vec3& came)
    {
        return judgeUlps(came, bilinearOracle(lookup), glm::dvec3(1.0), 1.0);
    }

    // No steeper than from one texel to the next.
    Judgement judgeStep(const Step& step, const StepColors& came)
    {
        const Lookup& from = step.lookup;
        const double moved
            = static_cast<double>(next(step).texCoord[step.axis]) - static_cast<double>(from.texCoord[step.axis]);
        const double ulps = ulpsBetween(came.next, glm::dvec3(came.at), glm::dvec3(sensitivity(from)));
        const double bound = 6.0 + moved * from.size[step.axis] / ulpOfOne / sensitivity(from);
        if (ulps <= bound)
            return right(ulps);
        return wrong(fmt::format("{} and {}", exactly(came.at), exactly(came.next)), "hardly a difference", ulps);
    }

    const Question<Lookup, glm::vec3> nearest { "stress.nearest", describeNearest, judgeNearest };
    const Question<Lookup, glm::vec3> bilinear { "stress.bilinear", describeBilinear, judgeBilinear };
    const Question<Lookup, glm::vec3> centre { "stress.bilinear", describeBilinear, judgeCentre };
    const Question<Step, StepColors> step { "stress.bilinear_step", describeStep, judgeStep };

    const Stress nearestAnywhere("texture.nearest.anywhere", nearest, randomly<Lookup>(1'500'000, anywhere));
    const Stress bilinearAnywhere("texture.bilinear.anywhere", bilinear, randomly<Lookup>(1'500'000, anywhere));
    const Stress centres("texture.bilinear.centres", centre, randomly<Lookup>(250'000, exactCentre));
    const Stress steps("texture.bilinear.continuity", step, randomly<Step>(500'000, [](Random& random) {
        const Lookup lookup = anywhere(random);
        return Step { lookup, random.integer(0, 1) };
    }));
    const Stress nearestSpecial("texture.nearest.special", nearest, constructed<Lookup>(specialLookups()));
    const Stress bilinearSpecial("texture.bilinear.special", bilinear, constructed<Lookup>(specialLookups()));

}
}
