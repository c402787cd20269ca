#include "files/error.h"
#include "files/scene_file.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <framework/variant_helper.h>

using namespace tests;

namespace {

bool isColor(const glm::vec3& color)
{
    return glm::all(glm::greaterThanEqual(color, glm::vec3(0.0f)))
        && glm::all(glm::lessThanEqual(color, glm::vec3(1.0f)));
}

void checkMaterial(const Material& material)
{
    CHECK(isColor(material.kd));
    CHECK(isColor(material.ks));
    CHECK(material.shininess > 0.0f);
    CHECK(material.transparency >= 0.0f);
    CHECK(material.transparency <= 1.0f);
}

void checkMesh(const Mesh& mesh)
{
    for (const glm::uvec3& t : mesh.triangles)
        REQUIRE(std::max({ t.x, t.y, t.z }) < mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) {
        REQUIRE(isFinite(vertex.position));
        REQUIRE(std::abs(glm::length(vertex.normal) - 1.0f) < 1e-5f);
    }
    checkMaterial(mesh.material);
}

void checkScene(const Scene& scene)
{
    std::size_t numTriangles = 0;
    for (const Mesh& mesh : scene.meshes) {
        checkMesh(mesh);
        numTriangles += mesh.triangles.size();
        const auto owns = [&](const auto& texture) { return texture.get() == mesh.material.kdTexture; };
        CHECK((!mesh.material.kdTexture || std::ranges::any_of(scene.textures, owns)));
    }
    for (const Sphere& sphere : scene.spheres) {
        CHECK(sphere.radius > 0.0f);
        checkMaterial(sphere.material);
    }
    CHECK(numTriangles + scene.spheres.size() > 0);
    CHECK_FALSE(scene.lights.empty());
    const auto colorsOf = make_visitor([](const PointLight& light) { return std::vector { light.color }; },
        [](const SegmentLight& light) {
            return std::vector { light.color0, light.color1 };
        },
        [](const ParallelogramLight& light) {
            return std::vector { light.color0, light.color1, light.color2, light.color3 };
        });
    for (const Scene::SceneLight& light : scene.lights)
        for (const glm::vec3& color : std::visit(colorsOf, light))
            CHECK((isFinite(color) && glm::all(glm::greaterThanEqual(color, glm::vec3(0.0f)))
                && color != glm::vec3(0.0f)));
}

}

TEST_CASE("Every scene of the course loads, with all that it shows in range", "[scenes]")
{
    for (int type = SingleTriangle; type < Custom; ++type) {
        CAPTURE(type);
        const Scene scene = loadScenePrebuilt(static_cast<SceneType>(type), RAYWORK_SCENES);
        CHECK(scene.type == type);
        checkScene(scene);
    }
    CHECK_THROWS_AS((void)loadScenePrebuilt(Custom, RAYWORK_SCENES), std::invalid_argument);
    CHECK_THROWS_AS((void)loadScenePrebuilt(Cube, "no folder"), files::Error);
}

TEST_CASE("Scenes have what their names promise", "[scenes]")
{
    const auto load = [](SceneType type) { return loadScenePrebuilt(type, RAYWORK_SCENES); };
    CHECK(load(SingleTriangle).meshes.at(0).triangles.size() == 1);
    CHECK(load(CubeTextured).meshes.at(0).material.kdTexture != nullptr);
    CHECK(load(Spheres).spheres.size() >= 2);
    const auto isTransparent = [](const Mesh& mesh) { return mesh.material.transparency < 1.0f; };
    CHECK(std::ranges::any_of(load(CornellBoxTransparency).meshes, isTransparent));
    const auto isParallelogram
        = [](const Scene::SceneLight& light) { return std::holds_alternative<ParallelogramLight>(light); };
    CHECK(std::ranges::any_of(load(CornellBoxParallelogramLight).lights, isParallelogram));
}

TEST_CASE("Every scene file in the folder loads, and its camera sees something", "[scenes]")
{
    for (const auto& entry : std::filesystem::directory_iterator(RAYWORK_SCENES)) {
        if (entry.path().extension() != ".toml")
            continue;
        CAPTURE(entry.path().filename().string());
        const auto [scene, config] = files::loadSceneFile(entry.path());
        checkScene(scene);
        World world(scene, { .enableAccelStructure = true });
        const Trackball camera = makeTrackball(config);
        int numHits = 0;
        for (float y = -0.95f; y < 1.0f; y += 0.1f) {
            for (float x = -0.95f; x < 1.0f; x += 0.1f) {
                Ray ray = camera.generateRay({ x, y });
                HitInfo hit;
                numHits += world.bvh.intersect(world.state, ray, hit);
            }
        }
        CHECK(numHits > 40); // a tenth of the picture
    }
}
