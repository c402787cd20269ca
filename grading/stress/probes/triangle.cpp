#include "grading/stress/probes/answer_all.h"
#include "grading/stress/probes/rays.h"
#include "intersect.h"

namespace stress {
namespace {

    Met meet(const grading::Triangle& triangle, Ray ray)
    {
        HitInfo hitInfo {};
        const bool isHit = intersectRayWithTriangle(triangle.v0, triangle.v1, triangle.v2, ray, hitInfo);
        return { isHit, ray.t, hitInfo.normal };
    }

    const worker::Probe triangle("stress.triangle", [](worker::Call& call) {
        answerAll<TriangleRay>(call, [](const TriangleRay& input) { return meet(input.triangle, input.ray); });
    });

    const worker::Probe box("stress.box", [](worker::Call& call) {
        answerAll<BoxRay>(call, [](BoxRay input) {
            const bool isHit = intersectRayWithShape(input.box, input.ray);
            return Met { isHit, input.ray.t, glm::vec3(0.0f) };
        });
    });

}
}
