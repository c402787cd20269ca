// The probe that renders with the submission's interpolation and nobody's traversal but the library's.
#include "interpolate.h"
#include "accel/traversal.h"
#include "bvh.h"
#include "worker/load_request.h"
#include "worker/measure_pixel.h"
#include "worker/probe.h"
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

namespace report {
namespace {

    // A submission's own BVH::intersect may well interpolate by other means: here nothing else can.
    class InterpolatedBVH : public accel::WrappedBVH {
    public:
        using WrappedBVH::WrappedBVH;

        bool intersect(RenderState& state, Ray& ray, HitInfo& hitInfo) const override
        {
            accel::TriangleHit hit;
            const Primitive* const found = accel::findClosest(wrapped(), ray, hit);
            if (!found)
                return false;
            const auto& [meshID, v0, v1, v2] = *found;
            const glm::vec3 point = ray.origin + ray.t * ray.direction;
            const glm::vec3 bc = computeBarycentricCoord(v0.position, v1.position, v2.position, point);
            hitInfo.barycentricCoord = bc;
            hitInfo.texCoord = interpolateTexCoord(v0.texCoord, v1.texCoord, v2.texCoord, bc);
            hitInfo.material = state.scene.meshes[meshID].material;
            hitInfo.normal = state.features.enableNormalInterp ? interpolateNormal(v0.normal, v1.normal, v2.normal, bc)
                                                               : glm::normalize(hit.normal);
            if (glm::dot(hitInfo.normal, ray.direction) > 0.0f)
                hitInfo.normal = -hitInfo.normal;
            return true;
        }
    };

    // As render.image, but of triangles alone.
    const worker::Probe interpolated("figures.interpolated", [](worker::Call& call) {
        const auto request = call.input.read<worker::RenderRequest>();
        const auto [scene, config] = worker::load(request);
        BVH bvh { scene, config.features };
        InterpolatedBVH interpolating { bvh };
        const accel::CountingBVH counting { interpolating };
        const worker::View view { worker::cameraOf(config, request), config.features, scene.lights, config.size,
            request.quantity };
        worker::Rendering rendering { .size = config.size };
        rendering.pixels.resize(static_cast<std::size_t>(config.size.x) * static_cast<std::size_t>(config.size.y));
        tbb::parallel_for(0, config.size.y, [&](int y) {
            for (int x = 0; x < config.size.x; ++x)
                rendering.pixels[static_cast<std::size_t>(y * config.size.x + x)]
                    = worker::measurePixel(scene, counting, view, { x, y });
        });
        call.output << rendering;
    });

}
}
