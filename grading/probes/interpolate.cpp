#include "interpolate.h"
#include "grading/probes/interpolation.h"
#include "worker/probe.h"

namespace grading {
namespace {

    // inputs -> what the function makes of each
    template <typename Input, typename Function> void answerAll(worker::Call& call, const Function& function)
    {
        std::vector<decltype(function(Input {}))> results;
        for (const Input& input : call.input.read<std::vector<Input>>())
            results.push_back(function(input));
        call.output << results;
    }

    const worker::Probe barycentric("interpolate.barycentric", [](worker::Call& call) {
        answerAll<TrianglePoint>(call, [](const TrianglePoint& input) {
            const auto& [v0, v1, v2] = input.triangle;
            return computeBarycentricCoord(v0, v1, v2, input.p);
        });
    });
    const worker::Probe normal("interpolate.normal", [](worker::Call& call) {
        answerAll<Weighted<glm::vec3>>(
            call, [](const auto& mean) { return interpolateNormal(mean.a, mean.b, mean.c, mean.weights); });
    });
    const worker::Probe texCoord("interpolate.texCoord", [](worker::Call& call) {
        answerAll<Weighted<glm::vec2>>(
            call, [](const auto& mean) { return interpolateTexCoord(mean.a, mean.b, mean.c, mean.weights); });
    });

}
}
