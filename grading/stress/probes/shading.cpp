#include "shading.h"
#include "grading/probes/empty_state.h"
#include "grading/stress/probes/answer_all.h"
#include "grading/stress/probes/gradient.h"
#include "grading/stress/probes/models.h"

namespace stress {
namespace {

    using grading::EmptyState;
    using grading::ShadingCase;

    const worker::Probe gradient("stress.gradient", [](worker::Call& call) {
        answerAll<GradientQuery>(call, [](const GradientQuery& query) {
            const auto begin = query.components.begin();
            return LinearGradient { { begin, begin + query.count } }.sample(query.ti);
        });
    });

    HitInfo hitOf(const ShadingCase& c)
    {
        HitInfo hit {};
        hit.normal = c.normal;
        hit.material = { .kd = c.kd, .ks = c.ks, .shininess = c.shininess };
        return hit;
    }

    const worker::Probe models("stress.models", [](worker::Call& call) {
        EmptyState empty;
        answerAll<ShadingCase>(call, [&](const ShadingCase& c) {
            const auto shade = [&](auto model) {
                return model(empty.state, c.cameraDirection, c.lightDirection, c.lightColor, hitOf(c), c.kd);
            };
            using Model = glm::vec3 (*)(
                RenderState&, const glm::vec3&, const glm::vec3&, const glm::vec3&, const HitInfo&, const glm::vec3&);
            return Models { shade(Model(computeLambertianModel)), shade(Model(computePhongModel)),
                shade(Model(computeBlinnPhongModel)) };
        });
    });

    const worker::Probe gradientModel("stress.gradient_model", [](worker::Call& call) {
        EmptyState empty;
        answerAll<ShadingCase>(call, [&](const ShadingCase& c) {
            return computeLinearGradientModel(
                empty.state, c.cameraDirection, c.lightDirection, c.lightColor, hitOf(c), gentleGradient);
        });
    });

    glm::vec3 compare(RenderState& state, const ShadingCase& c)
    {
        return computeLinearGradientModelComparison(
            state, c.cameraDirection, c.lightDirection, c.lightColor, hitOf(c), sidesOfZero);
    }

    const worker::Probe comparison("stress.comparison", [](worker::Call& call) {
        EmptyState empty;
        answerAll<ShadingCase>(call, [&](const ShadingCase& c) { return compare(empty.state, c); });
    });
    const worker::Probe comparisons("stress.comparisons", [](worker::Call& call) {
        EmptyState empty;
        answerAll<Comparisons>(call, [&](const Comparisons& pair) {
            return ComparisonColors { compare(empty.state, pair.phongIsBrighter),
                compare(empty.state, pair.blinnPhongIsBrighter) };
        });
    });

}
}
