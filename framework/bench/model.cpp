#include "bench/model.h"
#include "accel/wide/tree.h"
#include "files/scene_file.h"
#include "sampler.h"
#include "shapes/shapes.h"
#include "submission/paths.h"
#include <glm/gtc/constants.hpp>
#include <glm/gtx/transform.hpp>

namespace bench {
namespace {

    constexpr float fieldOfView = 0.87f;

    void addMesh(Model& model, const Mesh& mesh, const glm::mat4& transform = glm::mat4(1.0f))
    {
        const auto corner
            = [&](uint32_t i) { return glm::vec3(transform * glm::vec4(mesh.vertices[i].position, 1.0f)); };
        for (const glm::uvec3& t : mesh.triangles)
            model.triangles.push_back({ corner(t.x), corner(t.y), corner(t.z) });
    }

    Trackball cameraAt(const glm::vec3& lookAt, const glm::vec3& rotation, float distance)
    {
        Trackball camera(fieldOfView);
        camera.setCamera(lookAt, glm::radians(rotation), distance);
        return camera;
    }

    void addLights(Model& model, const std::vector<Scene::SceneLight>& lights)
    {
        for (const Scene::SceneLight& light : lights) {
            if (const auto* point = std::get_if<PointLight>(&light))
                model.lights.push_back(point->position);
            if (const auto* segment = std::get_if<SegmentLight>(&light))
                model.lights.insert(model.lights.end(), { segment->endpoint0, segment->endpoint1 });
            if (const auto* area = std::get_if<ParallelogramLight>(&light))
                model.lights.insert(model.lights.end(),
                    { area->v0, area->v0 + area->edge01, area->v0 + area->edge02,
                        area->v0 + area->edge01 + area->edge02 });
        }
    }

    struct Extent {
        glm::vec3 middle, size;
    };

    Extent extentOf(std::span<const Triangle> triangles)
    {
        glm::vec3 lower(INFINITY), upper(-INFINITY);
        for (const Triangle& triangle : triangles) {
            for (const glm::vec3& corner : triangle) {
                lower = glm::min(lower, corner);
                upper = glm::max(upper, corner);
            }
        }
        return { 0.5f * (lower + upper), upper - lower };
    }

    // Of the camera's rays, how many meet the side that counts its corners counter-clockwise.
    float shareOfFronts(std::span<const Triangle> triangles, const Trackball& camera)
    {
        constexpr int side = 64;
        const accel::WideTree tree(triangles);
        int count = 0;
        for (int i = 0; i < side * side; ++i) {
            const Ray ray = camera.generateRay(2.0f * (glm::vec2(i % side, i / side) + 0.5f) / float(side) - 1.0f);
            if (const auto hit = tree.closest(ray)) {
                const auto& [a, b, c] = triangles[hit->primitive];
                count += glm::dot(glm::cross(b - a, c - a), ray.direction) < 0.0f;
            }
        }
        return static_cast<float>(count) / static_cast<float>(side * side);
    }

    Model makeBowl()
    {
        constexpr uint32_t steps = 64;
        constexpr float radius = 1000.0f;
        Mesh bowl;
        for (uint32_t i = 0; i <= steps; ++i) {
            for (uint32_t j = 0; j <= steps; ++j) {
                const float up = static_cast<float>(i) / steps * glm::half_pi<float>();
                const float around = static_cast<float>(j % steps) / steps * glm::two_pi<float>();
                const float side = radius * std::sin(up);
                bowl.vertices.push_back(
                    { { side * std::cos(around), radius - radius * std::cos(up) - 0.5f, side * std::sin(around) }, {},
                        {} });
            }
        }
        for (uint32_t i = 0; i < steps; ++i) {
            for (uint32_t j = 0; j < steps; ++j) {
                const uint32_t corner = i * (steps + 1) + j, next = corner + steps + 1;
                bowl.triangles.emplace_back(corner, corner + 1, next + 1);
                bowl.triangles.emplace_back(corner, next + 1, next);
            }
        }
        Model model { .name = "bowl" };
        addMesh(model, bowl);
        addMesh(model, *shapes::makeShape("teapot"),
            glm::translate(glm::vec3(0.0f, -0.5f, 0.0f)) * glm::scale(glm::vec3(0.3f)));
        model.cameras = { cameraAt({ 0.0f, 0.0f, 0.0f }, { 20.0f, 15.0f, 0.0f }, 2.5f) };
        model.lights = { { 1.5f, 2.5f, -2.5f }, { -300.0f, 500.0f, 200.0f } };
        return model;
    }

    Model makeField()
    {
        constexpr int side = 9, number = 72;
        const Mesh teapot = *shapes::makeShape("teapot");
        Model model { .name = "field" };
        Sampler sampler(1);
        for (int i = 0; i < number; ++i) {
            const glm::vec3 place { static_cast<float>(i % side - side / 2) * 6.0f, 0.0f,
                static_cast<float>(i / side - side / 2) * 6.0f };
            const float angle = glm::two_pi<float>() * sampler.next_1d();
            addMesh(model, teapot, glm::translate(place) * glm::rotate(angle, glm::vec3(0.2f, 1.0f, 0.1f)));
        }
        const glm::vec3 a { -40, -1.5, -40 }, b { 40, -1.5, -40 }, c { 40, -1.5, 40 }, d { -40, -1.5, 40 };
        model.triangles.insert(model.triangles.end(), { Triangle { a, b, c }, Triangle { a, c, d } });
        model.cameras = { cameraAt({ 0.0f, 0.0f, 0.0f }, { 25.0f, 20.0f, 0.0f }, 35.0f) };
        model.lights = { { 10.0f, 20.0f, -10.0f }, { -30.0f, 15.0f, 5.0f } };
        return model;
    }

}

Model loadMesh(const std::filesystem::path& path)
{
    const files::SceneFile file = files::loadSceneFile(path);
    Model model { .name = path.stem().string() };
    for (const Mesh& mesh : file.scene.meshes)
        addMesh(model, mesh);
    const auto [middle, size] = extentOf(model.triangles);
    const float alongFloor = size.x > size.z ? 90.0f : 0.0f;
    const Trackball outside = cameraAt(middle, { 20.0f, 20.0f, 0.0f }, 1.25f * std::max({ size.x, size.y, size.z }));
    const Trackball inside = cameraAt(middle, { 5.0f, alongFloor, 0.0f }, 0.01f);
    if (shareOfFronts(model.triangles, outside) >= shareOfFronts(model.triangles, inside)) {
        model.cameras = { outside };
        model.lights = { { 1.5f, 2.5f, -2.5f }, { -3.0f, 1.0f, -1.0f } };
    } else {
        model.cameras = { inside };
        model.lights = { middle + 0.3f * size, middle - 0.2f * size, middle };
    }
    return model;
}

Model loadModel(const std::string& name)
{
    if (name == "bowl")
        return makeBowl();
    if (name == "field")
        return makeField();
    const auto folder = std::filesystem::path(submission::sourceDirectory) / "scenes";
    const files::SceneFile file = files::loadSceneFile(folder / (name + ".toml"));
    Model model { .name = name };
    for (const Mesh& mesh : file.scene.meshes)
        addMesh(model, mesh);
    model.cameras = { makeTrackball(file.config) };
    addLights(model, file.scene.lights);
    return model;
}

}
