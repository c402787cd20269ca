#include "shading.h"
#include "grading/probes/empty_state.h"
#include "grading/probes/render_replicate.h"
#include "grading/probes/shading_case.h"
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

    using Model = glm::vec3 (*)(
        RenderState&, const glm::vec3&, const glm::vec3&, const glm::vec3&, const HitInfo&, const LinearGradient&);

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

    // A pixel's colour by the scene's point lights. withCosine: with the course's optional factor max(cosine, 0).
    glm::vec3 shade(RenderState& state, Ray ray, const LinearGradient& gradient, bool withCosine)
    {
        HitInfo hit;
        glm::vec3 color { 0.0f };
        if (!state.bvh.intersect(state, ray, hit))
            return color;
        for (const Scene::SceneLight& any : state.scene.lights) {
            const auto& light = std::get<PointLight>(any);
            const glm::vec3 toLight = glm::normalize(light.position - (ray.origin + ray.t * ray.direction));
            const float factor = withCosine ? std::max(glm::dot(hit.normal, toLight), 0.0f) : 1.0f;
            color += factor * computeLinearGradientModel(state, -ray.direction, toLight, light.color, hit, gradient);
        }
        return color;
    }

    // a ReplicatesRequest, components, withCosine -> Replicates
    const worker::Probe picture("shading.replicates", [](worker::Call& call) {
        const auto request = call.input.read<ReplicatesRequest>();
        const LinearGradient gradient { call.input.read<std::vector<LinearGradient::Component>>() };
        const auto withCosine = call.input.read<bool>();
        call.output << replicate(request, [&](RenderState& state, std::span<const Ray> rays) {
            glm::vec3 sum { 0.0f };
            for (const Ray& ray : rays)
                sum += shade(state, ray, gradient, withCosine);
            return sum / static_cast<float>(rays.size());
        });
    });

    const worker::Probe model("shading.model", [](worker::Call& call) { shadeAll(call, computeLinearGradientModel); });
    const worker::Probe comparison(
        "shading.comparison", [](worker::Call& call) { shadeAll(call, computeLinearGradientModelComparison); });

}
}
