#include "interpolate.h"
#include "grading/probes/interpolation.h"
#include "grading/stress/probes/answer_all.h"

namespace stress {
namespace {

    const worker::Probe barycentric("stress.barycentric", [](worker::Call& call) {
        answerAll<grading::TrianglePoint>(call, [](const grading::TrianglePoint& input) {
            const auto& [v0, v1, v2] = input.triangle;
            return computeBarycentricCoord(v0, v1, v2, input.p);
        });
    });

}
}
