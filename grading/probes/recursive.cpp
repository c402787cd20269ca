#include "recursive.h"
#include "grading/probes/recursion.h"
#include "grading/probes/scripted_bvh.h"
#include "scene.h"
#include "worker/probe.h"

namespace grading {
namespace {

    using Generate = Ray (*)(Ray, HitInfo);
    using Component = void (*)(RenderState&, Ray, const HitInfo&, glm::vec3&, int);

    // incidences -> rays
    void generateAll(worker::Call& call, Generate generate)
    {
        std::vector<Ray> rays;
        for (const Incidence& incidence : call.input.read<std::vector<Incidence>>())
            rays.push_back(generate(incidence.ray, incidence.hitInfo));
        call.output << rays;
    }

    // recursion -> its answer
    void renderComponent(worker::Call& call, Component component, const Features& features)
    {
        const auto recursion = call.input.read<Recursion>();
        Scene scene;
        scene.lights.push_back(PointLight { glm::vec3(0.0f), recursion.light });
        const ScriptedBVH bvh { recursion.hits };
        RenderState state { scene, features, bvh, Sampler(0) };
        RecursionAnswer answer { recursion.hitColor, {} };
        const auto& [ray, hitInfo] = recursion.incidence;
        component(state, ray, hitInfo, answer.hitColor, recursion.rayDepth);
        answer.rays = bvh.rays();
        call.output << answer;
    }

    const worker::Probe reflectionRay(
        "recursive.reflectionRay", [](worker::Call& call) { generateAll(call, generateReflectionRay); });
    const worker::Probe passthroughRay(
        "recursive.passthroughRay", [](worker::Call& call) { generateAll(call, generatePassthroughRay); });
    const worker::Probe specular("recursive.specular",
        [](worker::Call& call) { renderComponent(call, renderRaySpecularComponent, { .enableReflections = true }); });
    const worker::Probe transparent("recursive.transparent", [](worker::Call& call) {
        renderComponent(call, renderRayTransparentComponent, { .enableTransparency = true });
    });

}
}
