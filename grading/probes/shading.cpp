#include "grading/probes/empty_state.h"
#include "grading/probes/shading_case.h"
#include "shading.h"
#include "worker/probe.h"

namespace grading {
namespace {

    // components, positions -> colours
    const worker::Probe sample("shading.gradient", [](worker::Call& call) {
        const LinearGradient gradient { call.input.read<std::vector<LinearGradient::Component>>() };
        std::vector<glm::vec3> colors;
        for (const float ti : call.input.read<std::vector<float>>())
            colors.push_back(gradient.sample(ti));
        call.output << colors;
    });

    using Model = glm::vec3 (*)(RenderState&, const glm::vec3&, const glm::vec3&, const glm::vec3&, const HitInfo&,
        const LinearGradient&);

    // components, cases -> colours
    void shadeAll(worker::Call& call, Model model)
    {
        const LinearGradient gradient { call.input.read<std::vector<LinearGradient::Component>>() };
        EmptyState empty;
        std::vector<glm::vec3> colors;
        for (const ShadingCase& c : call.input.read<std::vector<ShadingCase>>()) {
            HitInfo hit {};
            hit.normal = c.normal;
            hit.material = { .kd = c.kd, .ks = c.ks, .shininess = c.shininess };
            colors.push_back(model(empty.state, c.cameraDirection, c.lightDirection, c.lightColor, hit, gradient));
        }
        call.output << colors;
    }

    const worker::Probe model("shading.model", [](worker::Call& call) { shadeAll(call, computeLinearGradientModel); });
    const worker::Probe comparison(
        "shading.comparison", [](worker::Call& call) { shadeAll(call, computeLinearGradientModelComparison); });

}
}
