#include "shading.h"
#include "files/scene_file.h"
#include "grading/probes/empty_state.h"
#include "grading/probes/shading_case.h"
#include "worker/probe.h"
#include "worker/render_request.h"

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

    // scene file, components, whether the course's optional factor max(cosine, 0) is in it -> a picture of 96 x 96
    // pixels, lit by the scene's point lights
    const worker::Probe picture("shading.picture", [](worker::Call& call) {
        const files::SceneFile file = files::loadSceneFile(call.input.read<std::string>());
        const LinearGradient gradient { call.input.read<std::vector<LinearGradient::Component>>() };
        const auto withCosine = call.input.read<bool>();
        const BVH bvh { file.scene, file.config.features };
        RenderState state { file.scene, file.config.features, bvh, Sampler(1) };
        const Trackball camera = makeTrackball(file.config);

        worker::Rendering rendering { .size = glm::ivec2(96) };
        for (int i = 0; i < rendering.size.x * rendering.size.y; ++i) {
            const glm::vec2 pixel { i % rendering.size.x, i / rendering.size.x };
            Ray ray = camera.generateRay((pixel + 0.5f) / glm::vec2(rendering.size) * 2.0f - 1.0f);
            HitInfo hit;
            glm::vec3 color { 0.0f };
            if (bvh.intersect(state, ray, hit)) {
                for (const Scene::SceneLight& any : file.scene.lights) {
                    const auto& light = std::get<PointLight>(any);
                    const glm::vec3 toLight = glm::normalize(light.position - (ray.origin + ray.t * ray.direction));
                    const float factor = withCosine ? std::max(glm::dot(hit.normal, toLight), 0.0f) : 1.0f;
                    color += factor
                        * computeLinearGradientModel(state, -ray.direction, toLight, light.color, hit, gradient);
                }
            }
            rendering.pixels.push_back(color);
        }
        call.output << rendering;
    });

    const worker::Probe model("shading.model", [](worker::Call& call) { shadeAll(call, computeLinearGradientModel); });
    const worker::Probe comparison(
        "shading.comparison", [](worker::Call& call) { shadeAll(call, computeLinearGradientModelComparison); });

}
}
