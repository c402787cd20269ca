#include "grading/stress/probes/spawned.h"
#include "grading/stress/probes/answer_all.h"
#include "intersect.h"
#include "recursive.h"

namespace stress {
namespace {

    bool meets(const grading::Triangle& triangle, Ray ray, HitInfo& hitInfo)
    {
        return intersectRayWithTriangle(triangle.v0, triangle.v1, triangle.v2, ray, hitInfo);
    }

    Spawned spawn(const TriangleRay& input)
    {
        const auto& [v0, v1, v2] = input.triangle;
        Spawned spawned { 0, input.ray, {}, {}, 0, 0 };
        HitInfo hitInfo {}, unused {};
        spawned.isHit = intersectRayWithTriangle(v0, v1, v2, spawned.ray, hitInfo);
        if (!spawned.isHit)
            return spawned;
        spawned.reflected = generateReflectionRay(spawned.ray, hitInfo);
        spawned.passedThrough = generatePassthroughRay(spawned.ray, hitInfo);
        spawned.reflectedMeets = meets(input.triangle, spawned.reflected, unused);
        spawned.passedThroughMeets = meets(input.triangle, spawned.passedThrough, unused);
        return spawned;
    }

    const worker::Probe spawned("stress.spawned", [](worker::Call& call) { answerAll<TriangleRay>(call, spawn); });

}
}
