#include "interpolate.h"
#include "grading/probes/interpolation.h"
#include "grading/stress/probes/answer_all.h"

namespace stress {
namespace {

    using grading::TrianglePoint;
    using grading::Weighted;

    const worker::Probe barycentric("stress.barycentric", [](worker::Call& call) {
        answerAll<TrianglePoint>(call, [](const TrianglePoint& input) {
            const auto& [v0, v1, v2] = input.triangle;
            return computeBarycentricCoord(v0, v1, v2, input.p);
        });
    });
    const worker::Probe normal("stress.normal", [](worker::Call& call) {
        answerAll<Weighted<glm::vec3>>(
            call, [](const auto& mean) { return interpolateNormal(mean.a, mean.b, mean.c, mean.weights); });
    });
    const worker::Probe texCoord("stress.texCoord", [](worker::Call& call) {
        answerAll<Weighted<glm::vec2>>(
            call, [](const auto& mean) { return interpolateTexCoord(mean.a, mean.b, mean.c, mean.weights); });
    });

}
}
