#include "files/feature_settings.h"
#include "files/scene_file.h"
#include "files/scene_writer.h"
#include "files/text.h"
#include "same_scene.h"
#include "temporary_folder.h"
#include <bit>
#include <catch2/catch.hpp>
#include <framework/variant_helper.h>
#include <random>

using files::loadSceneFile;
using files::saveScene;
using files::SceneFile;
using files_test::sameBits;
using files_test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

using Lights = std::vector<Scene::SceneLight>;

const std::string triangleObj = "v 10 0 0\nv 14 0 0\nv 12 3 0\nf 1 2 3\n";

// Each setting another one.
Config changed(Config config)
{
    for (const std::string& name : files::featureNames()) {
        const auto change = make_visitor([](bool on) -> files::FeatureValue { return !on; },
            [&](int64_t count) -> files::FeatureValue {
                return count == files::countRange(name).most ? count - 1 : count + 1;
            },
            [](const std::string& model) -> files::FeatureValue {
                return std::string(model == "phong" ? "linear_gradient_comparison" : "phong");
            });
        files::setFeatureValue(config.features, name, std::visit(change, files::featureValue(config.features, name)));
    }
    config.size += glm::ivec2(1, 2);
    config.camera = { .lookAt = { 0.1f, -0.0f, 1e-30f },
        .rotation = { 1.0f / 3.0f, -720.0f, 16777217.0f },
        .distanceFromLookAt = std::nextafter(config.camera.distanceFromLookAt, 100.0f),
        .fieldOfView = 179.999f }; // the largest
    return config;
}

class RandomFloats {
public:
    glm::vec3 point() { return { number(), number(), number() }; }
    glm::vec3 color() { return glm::abs(point()); }

private:
    // All finite ones.
    float number()
    {
        const auto candidate = std::bit_cast<float>(static_cast<uint32_t>(m_bits()));
        return std::isfinite(candidate) ? candidate : number();
    }

    std::mt19937 m_bits { 1 };
};

// Of each kind some, in no order of kinds.
Lights randomLights()
{
    RandomFloats random;
    Lights lights;
    for (int i = 0; i < 10; ++i) {
        const auto p = [&] { return random.point(); };
        const auto c = [&] { return random.color(); };
        lights.emplace_back(ParallelogramLight { p(), p(), p(), c(), c(), c(), c() });
        lights.emplace_back(PointLight { p(), c() });
        lights.emplace_back(SegmentLight { p(), p(), c(), c() });
    }
    return lights;
}

void checkReadBack(const fs::path& saved, const Scene& original, const Config& config, const Lights& lights)
{
    const SceneFile read = loadSceneFile(saved);
    files_test::checkSameScene(read.scene, original);
    files_test::checkSameConfig(read.config, config);
    CHECK(sameBits(read.scene.lights, lights));
}

std::vector<fs::path> sceneFiles()
{
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(RAYWORK_SCENES))
        if (entry.path().extension() == ".toml")
            names.push_back(entry.path().filename());
    return names;
}

}

TEST_CASE("Every scene of the folder with other settings and lights is read back as it was saved", "[files]")
{
    const fs::path name = GENERATE(from_range(sceneFiles()));
    INFO(name);
    const TemporaryFolder folder;
    fs::copy(RAYWORK_SCENES, folder / "scenes", fs::copy_options::recursive);
    fs::create_directories(folder / "else/where");
    const fs::path path = folder / "scenes" / name;
    const SceneFile file = loadSceneFile(path);
    const Config config = changed(file.config);

    const fs::path elsewhere = folder / "else/where/a.toml";
    saveScene(elsewhere, path, config, randomLights());
    checkReadBack(elsewhere, file.scene, config, randomLights());
    saveScene(path, path, config, {});
    checkReadBack(path, file.scene, config, {});
    saveScene(folder / "b.toml", elsewhere, file.config, file.scene.lights);
    checkReadBack(folder / "b.toml", file.scene, file.config, file.scene.lights);
}

TEST_CASE("A saved model is the scene that it was by itself", "[files]")
{
    const TemporaryFolder folder;
    folder.write("models/a.tga", files_test::tinyTga());
    folder.write("models/m.mtl", "newmtl a\nKd 1 0 0.1\nNs 5\nd 0.3\nmap_Kd a.tga\nnewmtl b\nKs 0 0.7 0\n");
    const fs::path model
        = folder.write("models/a.Obj", "mtllib m.mtl\nusemtl a\n" + triangleObj + "v 1 2 3\nusemtl b\nf 1 2 4\n");
    const SceneFile file = loadSceneFile(model);
    REQUIRE(file.scene.meshes.size() == 2);
    for (const char* name : { "models/a.toml", "a.toml" }) {
        saveScene(folder / name, model, file.config, file.scene.lights);
        checkReadBack(folder / name, file.scene, file.config, file.scene.lights);
    }
}

TEST_CASE("A saved scene names its files from where it lies", "[files]")
{
    const TemporaryFolder folder;
    folder.write("store/models/a \"1\"\\\n.obj", "mtllib m.mtl\nusemtl a\n" + triangleObj);
    folder.write("store/models/m.mtl", "newmtl a\nKd 0 0 1\n");
    folder.write("store/a.tga", files_test::tinyTga());
    const fs::path texture = folder / "store/a.tga";
    const fs::path path = folder.write("scenes/a.toml",
        R"(
[[mesh]]
file = "../store/models/a \"1\"\\\n.obj"
[[mesh]]
quads = [[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]]
texture = ")"
            + texture.string() + "\"\n");
    const SceneFile file = loadSceneFile(path);

    SECTION("when all of it is moved together")
    {
        saveScene(folder / "scenes/deeper.toml", path, file.config, {});
        fs::create_directories(folder / "moved");
        fs::rename(folder / "scenes", folder / "moved/scenes");
        fs::copy(folder / "store", folder / "moved/store", fs::copy_options::recursive);
        checkReadBack(folder / "moved/scenes/deeper.toml", file.scene, file.config, {});
    }
    SECTION("when either folder is a link")
    {
        fs::create_directories(folder / "far/away");
        fs::create_directory_symlink(folder / "far/away", folder / "link");
        fs::create_directory_symlink(folder / "scenes", folder / "far/scenes");
        saveScene(folder / "link/b.toml", folder / "far/scenes/a.toml", file.config, {});
        checkReadBack(folder / "link/b.toml", file.scene, file.config, {});
        checkReadBack(folder / "far/away/b.toml", file.scene, file.config, {});
    }
    SECTION("when a model is a link, beside which its materials lie")
    {
        fs::rename(folder / "store/models/a \"1\"\\\n.obj", folder / "a.obj");
        fs::create_symlink(folder / "a.obj", folder / "store/models/a \"1\"\\\n.obj");
        saveScene(folder / "b.toml", path, file.config, {});
        checkReadBack(folder / "b.toml", file.scene, file.config, {});
    }
    SECTION("when names are from the folder of the process")
    {
        saveScene(fs::relative(folder / "b.toml"), fs::relative(path), file.config, {});
        checkReadBack(folder / "b.toml", file.scene, file.config, {});
    }
}

TEST_CASE("A float whose shortest text as a double rounds to another is read back", "[files]")
{
    const auto number = std::bit_cast<float>(0x15ae43fdu);
    REQUIRE(static_cast<float>(7.038531e-26) != number);
    const TemporaryFolder folder;
    const fs::path path = folder.write("a.toml", "");
    const Lights lights { PointLight { glm::vec3(number), glm::vec3(std::numeric_limits<float>::max()) } };
    saveScene(path, path, Config {}, lights);
    checkReadBack(path, Scene {}, Config {}, lights);
}

TEST_CASE("A saved scene reads like one that was written by hand", "[files]")
{
    const TemporaryFolder folder;
    const fs::path path = folder.write("a.toml", R"(size = [1, 1]
mesh = [{ triangles = [[[0, 0.1, 0], [1, 0, 0], [0, 1e-7, -0.0]]], kd = [0.3, 1, 1] }, { shape = "cube" }]
[frame]
unit = 2
[[light]]
type = "point"
position = [0, 0, 0]
color = [9, 9, 9]
)");
    Config config;
    config.features.enableShading = true;
    saveScene(path, path, config, { PointLight { { 0.1f, 2.0f, -1.5f }, glm::vec3(1.0f) } });
    CHECK(files::readText(path) == R"(size = [800, 800]

[camera]
look_at = [0.0, 0.0, 0.0]
rotation = [20.0, 20.0, 0.0]
distance = 3.0
field_of_view = 50.0

[features]
shading = true

[[mesh]]
kd = [0.3, 1, 1]
triangles = [
    [[0, 0.1, 0], [1, 0, 0], [0, 1e-07, -0.0]],
]

[[mesh]]
shape = "cube"

[frame]
unit = 2

[[light]]
type = "point"
position = [0.1, 2.0, -1.5]
color = [1.0, 1.0, 1.0]
in_world = true
)");
}
