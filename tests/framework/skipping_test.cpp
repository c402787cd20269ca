#include "accel/counting_bvh.h"
#include "files/scene_file.h"
#include "light.h"
#include "screen.h"
#include "shading.h"
#include "values/needs_of.h"
#include "worker/library_bvh.h"
#include "worker/specialised.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace tests;

namespace {

// Everything on: what is left out is left out because of the scene.
files::SceneFile smallScene(const std::filesystem::path& path, ShadingModel model)
{
    files::SceneFile file = files::loadSceneFile(path);
    file.config.size = { 20, 15 };
    Features& features = file.config.features;
    features.enableShading = features.enableShadows = features.enableReflections = features.enableTransparency = true;
    features.enableTextureMapping = features.enableNormalInterp = features.enableAccelStructure = true;
    features.shadingModel = model;
    features.numShadowSamples = 5; // enough to look at what is between
    features.numPixelSamples = model == ShadingModel::Lambertian ? 1 : 2; // through the centre, or anywhere
    return file;
}

template <typename Tree> std::vector<glm::vec3> render(files::SceneFile file, bool skips, std::size_t numThreads = 4)
{
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, numThreads);
    file.config.features.extra.enableSkipping = skips;
    const Tree bvh(file.scene, file.config.features);
    Screen screen(file.config.size);
    renderImage(file.scene, bvh, file.config.features, makeTrackball(file.config), screen);
    return screen.pixels();
}

std::vector<glm::vec3> renderBySpecialisedCode(const files::SceneFile& file)
{
    const worker::LibraryBVH bvh(file.scene, file.config.features);
    Screen screen(file.config.size);
    worker::renderSpecialised(file.scene, bvh, file.config.features, makeTrackball(file.config), screen);
    return screen.pixels();
}

Scene sceneOf(const Material& material)
{
    Scene scene;
    addPane(scene, material, 1.0f);
    scene.lights.emplace_back(PointLight { glm::vec3(0.0f), glm::vec3(1.0f) });
    return scene;
}

bool isNeeded(bool SceneNeeds::*need, const Scene& scene, const Features& features)
{
    return values::needsOf(scene, features).*need;
}

}

TEST_CASE("What is skipped changes no bit of any scene, whoever traverses, with one thread and with many", "[skipping]")
{
    const auto model = GENERATE(ShadingModel::Lambertian, ShadingModel::BlinnPhong, ShadingModel::LinearGradient);
    for (const auto& entry : std::filesystem::directory_iterator(RAYWORK_SCENES)) {
        if (entry.path().extension() != ".toml")
            continue;
        const files::SceneFile file = smallScene(entry.path(), model);
        INFO(entry.path());
        const auto expected = render<BVH>(file, false);
        CHECK(render<BVH>(file, true) == expected);
        CHECK(render<BVH>(file, true, 1) == expected);
        const auto expectedOfLibrary = render<worker::LibraryBVH>(file, false);
        CHECK(render<worker::LibraryBVH>(file, true) == expectedOfLibrary);
        CHECK(renderBySpecialisedCode(file) == expectedOfLibrary);
    }
}

TEST_CASE("A part is needed if its feature is on and the scene has some", "[skipping]")
{
    Features on;
    on.enableTextureMapping = on.enableReflections = on.enableTransparency = on.enableNormalInterp = true;
    on.enableShadows = on.enableShading = true;
    const Image image(1, 1);
    const Material plain { .kd = glm::vec3(1.0f) };
    const Material textured { .kdTexture = &image };
    const Material mirror { .ks = glm::vec3(1.0f) };
    const Material glass { .transparency = 0.5f };
    struct Case {
        bool SceneNeeds::*need;
        Material material;
        bool Features::*feature;
    };
    for (const Case& c : { Case { &SceneNeeds::textures, textured, &Features::enableTextureMapping },
             Case { &SceneNeeds::mirrors, mirror, &Features::enableReflections },
             Case { &SceneNeeds::transparency, glass, &Features::enableTransparency },
             Case { &SceneNeeds::shadowsInOrder, glass, &Features::enableTransparency },
             Case { &SceneNeeds::shadowsInOrder, glass, &Features::enableShadows } }) {
        CHECK(isNeeded(c.need, sceneOf(c.material), on));
        CHECK_FALSE(isNeeded(c.need, sceneOf(plain), on));
        Features off = on;
        off.*c.feature = false;
        CHECK_FALSE(isNeeded(c.need, sceneOf(c.material), off));
        off.extra.enableSkipping = false;
        CHECK(isNeeded(c.need, sceneOf(plain), off));
    }
    CHECK(isNeeded(&SceneNeeds::triangles, sceneOf(plain), on));
    CHECK_FALSE(isNeeded(&SceneNeeds::triangles, Scene {}, on));
    CHECK_FALSE(isNeeded(&SceneNeeds::spheres, sceneOf(plain), on));
    CHECK(isNeeded(&SceneNeeds::shadows, sceneOf(plain), on));
    CHECK_FALSE(isNeeded(&SceneNeeds::shadows, Scene {}, on));
    CHECK(isNeeded(&SceneNeeds::shadingNormals, sceneOf(plain), on));
}

TEST_CASE("A list of rays is needed for several samples, and for numbers that are spread over it", "[skipping]")
{
    Features features;
    CHECK_FALSE(isNeeded(&SceneNeeds::pixelRays, Scene {}, features));
    features.extra.enableOwenSampling = true;
    CHECK(isNeeded(&SceneNeeds::pixelRays, Scene {}, features));
    features = { .numPixelSamples = 2 };
    CHECK(isNeeded(&SceneNeeds::pixelRays, Scene {}, features));
}

TEST_CASE("Light from behind matters where a model may show it", "[skipping]")
{
    const Scene scene = sceneOf({ .kd = glm::vec3(1.0f) });
    for (const ShadingModel model : { ShadingModel::Lambertian, ShadingModel::Phong, ShadingModel::BlinnPhong,
             ShadingModel::LinearGradient, ShadingModel::LinearGradientComparison }) {
        Features features { .enableShading = true, .shadingModel = model };
        const bool isGradient = model >= ShadingModel::LinearGradient;
        CHECK(isNeeded(&SceneNeeds::lightFromBehind, scene, features) == isGradient);
        features.enableShading = false;
        CHECK(isNeeded(&SceneNeeds::lightFromBehind, scene, features));
    }
}

TEST_CASE("Light that cannot be seen is black in every provided model", "[skipping]")
{
    grading::Random random(3);
    World world;
    world.features.enableShading = true;
    world.state.needs.lightFromBehind = false;
    const auto direction = [&] {
        return glm::normalize(glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1f, 1)));
    };
    int numLit = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 kd(static_cast<float>(random.integer(0, 1))), ks(static_cast<float>(random.integer(0, 1)));
        const glm::vec3 color(static_cast<float>(random.integer(0, 1)));
        const glm::vec3 light = random.integer(0, 1) ? direction() : -direction();
        const HitInfo hit { .normal = direction(), .material = { .kd = kd, .ks = ks, .shininess = 3.0f } };
        const bool lit = canBeLit(world.state, light, color, hit);
        numLit += lit;
        for (const ShadingModel model : { ShadingModel::Lambertian, ShadingModel::Phong, ShadingModel::BlinnPhong }) {
            world.features.shadingModel = model;
            const glm::vec3 shown = computeShading(world.state, direction(), light, color, hit);
            if (!lit)
                REQUIRE(shown == glm::vec3(0.0f));
        }
        world.state.needs.lightFromBehind = true;
        REQUIRE(canBeLit(world.state, light, color, hit));
        world.state.needs.lightFromBehind = false;
    }
    CHECK(numLit > 200);
    CHECK(numLit < 1000);
}

TEST_CASE("A ray is occluded exactly if it meets something", "[skipping]")
{
    files::SceneFile file = files::loadSceneFile(RAYWORK_SCENES "/monkey.toml");
    file.scene.spheres.push_back({ glm::vec3(0.8f), 0.5f, {} });
    const worker::LibraryBVH bvh(file.scene, file.config.features);
    RenderState state { file.scene, file.config.features, bvh, Sampler(1) };
    grading::Random random(5);
    const auto point = [&] { return glm::vec3(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)); };
    int numHits = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 from = point();
        const Ray ray { from, point() - from, random.uniform(0, 1.5f) };
        Ray shortened = ray;
        HitInfo hit;
        const bool meets = bvh.intersect(state, shortened, hit);
        REQUIRE(bvh.isOccluded(state, ray) == meets);
        numHits += meets;
    }
    CHECK(numHits > 500);
    CHECK(numHits < 4500);
}

TEST_CASE("Scenes without glass trace fewer rays, and those that they left out are counted", "[skipping]")
{
    const std::string name = GENERATE("cornell_box", "soft_shadows");
    files::SceneFile file = smallScene(RAYWORK_SCENES "/" + name + ".toml", ShadingModel::Lambertian);
    const auto raysOf = [&](bool skips) {
        file.config.features.extra.enableSkipping = skips;
        worker::LibraryBVH bvh(file.scene, file.config.features);
        const accel::CountingBVH counting(bvh);
        Screen screen(file.config.size);
        const accel::RayCounts before = accel::CountingBVH::rayCounts();
        renderImage(file.scene, counting, file.config.features, makeTrackball(file.config), screen);
        return accel::CountingBVH::rayCounts() - before;
    };
    const accel::RayCounts all = raysOf(false), needed = raysOf(true);
    CHECK(all.leftOut() == 0);
    CHECK(needed.unlit > 0);
    CHECK((needed.clear > 0) == (name == "soft_shadows")); // the box has points for lights
    CHECK(needed.total() + needed.leftOut() == all.total());
}
