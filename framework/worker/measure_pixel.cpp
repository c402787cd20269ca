#include "worker/measure_pixel.h"
#include "debug/cause.h"
#include "debug/tally.h"
#include "recursive.h"
#include "render.h"
#include "worker/middle_ray.h"

namespace worker {
namespace {

    using debug::Quantity;

    glm::vec3 number(uint64_t count)
    {
        return { static_cast<float>(count), 0.0f, 0.0f };
    }

    // Boxes are counted as they are drawn: it is the only thing that a submission tells of its traversal. What it does
    // only to draw is not counted otherwise.
    Features featuresFor(const View& view)
    {
        Features features = view.features;
        if (view.quantity != Quantity::Color)
            features.enableDebugDraw = view.quantity == Quantity::NodesVisited;
        return features;
    }

    glm::vec3 trace(RenderState& state, const View& view, glm::ivec2 pixel)
    {
        const debug::Watch watch; // whoever shows pixels one by one shows rays by kind
        return renderRays(state, generatePixelRays(state, view.camera, pixel, view.size));
    }

    glm::vec3 countRays(RenderState& state, const View& view, glm::ivec2 pixel)
    {
        const uint64_t before = accel::CountingBVH::numRaysOfThisThread();
        (void)trace(state, view, pixel);
        return number(accel::CountingBVH::numRaysOfThisThread() - before);
    }

    glm::vec3 measureHit(Quantity quantity, const HitInfo& hitInfo, const Ray& ray)
    {
        switch (quantity) {
        case Quantity::Normal:
            return hitInfo.normal;
        case Quantity::TexCoord:
            return { hitInfo.texCoord, 0.0f };
        case Quantity::Barycentric:
            return hitInfo.barycentricCoord;
        default:
            return { ray.t, 0.0f, 0.0f };
        }
    }

    glm::vec3 measureMiddle(RenderState& state, Quantity quantity, Ray ray)
    {
        const debug::Tally tally;
        HitInfo hitInfo {};
        const bool hasHit = state.bvh.intersect(state, ray, hitInfo);
        if (quantity == Quantity::NodesVisited)
            return number(tally.numNodes());
        if (quantity == Quantity::TrianglesTested)
            return number(tally.numTriangles());
        return hasHit ? measureHit(quantity, hitInfo, ray) : debug::nothing;
    }

}

glm::vec3 measurePixel(
    const Scene& scene, const accel::CountingBVH& bvh, const View& view, glm::ivec2 pixel, const SceneNeeds& needs)
{
    const auto index = static_cast<uint32_t>(pixel.y * view.size.x + pixel.x); // the seed that renderImage takes
    const Features features = featuresFor(view);
    RenderState state { scene, features, bvh, Sampler(index), needs };
    switch (view.quantity) {
    case Quantity::Color:
        return trace(state, view, pixel);
    case Quantity::Samples:
        return number(generatePixelRays(state, view.camera, pixel, view.size).size());
    case Quantity::Rays:
        return countRays(state, view, pixel);
    default:
        return measureMiddle(state, view.quantity, middleRay(view.camera, pixel, view.size));
    }
}

}
