#include "files/error.h"
#include "files/scene_file.h"
#include "temporary_folder.h"
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using files_test::TemporaryFolder;

namespace {

constexpr float rounding = 1e-5f; // of a few operations on floats of about 1

const std::string triangleObj = "v 10 0 0\nv 14 0 0\nv 12 3 0\nf 1 2 3\n";

bool near(const glm::vec3& a, const glm::vec3& b)
{
    return glm::distance(a, b) < rounding;
}

}

TEST_CASE("An empty scene file leaves all defaults", "[files]")
{
    const TemporaryFolder folder;
    const files::SceneFile file = files::loadSceneFile(folder.write("a.toml", ""));
    CHECK(file.scene.meshes.empty());
    CHECK(file.config.size == Config {}.size);
    CHECK(file.config.camera.distanceFromLookAt == CameraConfig {}.distanceFromLookAt);
}

TEST_CASE("A scene file sets size, camera and features", "[files]")
{
    const TemporaryFolder folder;
    const Config config = files::loadSceneFile(folder.write("a.toml", R"(size = [320, 200]
[camera]
look_at = [1, 2.5, -3]
rotation = [10, 20, 30]
distance = 4
field_of_view = 60.5
[features]
shading = true
bloom = true
shading_model = "blinn_phong"
pixel_samples = 16
)"))
                              .config;
    CHECK(config.size == glm::ivec2(320, 200));
    CHECK(config.camera.lookAt == glm::vec3(1, 2.5f, -3));
    CHECK(config.camera.rotation == glm::vec3(10, 20, 30));
    CHECK(config.camera.distanceFromLookAt == 4.0f);
    CHECK(config.camera.fieldOfView == 60.5f);
    CHECK(config.features.enableShading);
    CHECK(config.features.extra.enableBloomEffect);
    CHECK(config.features.shadingModel == ShadingModel::BlinnPhong);
    CHECK(config.features.numPixelSamples == 16);
    CHECK_FALSE(config.features.enableShadows);
}

TEST_CASE("The frame moves and scales points but only scales edges and radii", "[files]")
{
    const TemporaryFolder folder;
    const Scene scene = files::loadSceneFile(folder.write("a.toml", R"(
[frame]
origin = [10, 20, 30]
unit = 0.5
[[mesh]]
quads = [[[10, 20, 30], [12, 20, 30], [12, 22, 30], [10, 22, 30]]]
kd = [1, 0.5, 0]
[[sphere]]
center = [12, 20, 30]
radius = 4
transparency = 0.25
[[light]]
type = "point"
position = [10, 24, 30]
color = [2, 1, 0]
[[light]]
type = "segment"
endpoint0 = [10, 20, 30]
endpoint1 = [11, 21, 31]
color0 = [1, 0, 0]
color1 = [0, 1, 0]
[[light]]
type = "parallelogram"
v0 = [10, 20, 32]
edge01 = [2, 0, 0]
edge02 = [0, 0, 4]
color0 = [1, 0, 0]
color1 = [0, 1, 0]
color2 = [0, 0, 1]
color3 = [1, 1, 1]
)"))
                            .scene;

    REQUIRE(scene.meshes.size() == 1);
    const Mesh& mesh = scene.meshes[0];
    REQUIRE(mesh.triangles.size() == 2);
    REQUIRE(mesh.vertices.size() == 4);
    CHECK(mesh.vertices[2] == Vertex { { 1, 1, 0 }, { 0, 0, 1 }, { 1, 1 } });
    CHECK(mesh.vertices[3].texCoord == glm::vec2(0, 1));
    CHECK(mesh.material.kd == glm::vec3(1, 0.5f, 0));

    REQUIRE(scene.spheres.size() == 1);
    CHECK(scene.spheres[0].center == glm::vec3(1, 0, 0));
    CHECK(scene.spheres[0].radius == 2.0f);
    CHECK(scene.spheres[0].material.transparency == 0.25f);

    REQUIRE(scene.lights.size() == 3);
    CHECK(std::get<PointLight>(scene.lights[0]).position == glm::vec3(0, 2, 0));
    CHECK(std::get<PointLight>(scene.lights[0]).color == glm::vec3(2, 1, 0));
    CHECK(std::get<SegmentLight>(scene.lights[1]).endpoint1 == glm::vec3(0.5f));
    const auto& light = std::get<ParallelogramLight>(scene.lights[2]);
    CHECK(light.v0 == glm::vec3(0, 0, 1));
    CHECK(light.edge01 == glm::vec3(1, 0, 0));
    CHECK(light.edge02 == glm::vec3(0, 0, 2));
    CHECK(light.color3 == glm::vec3(1));
}

TEST_CASE("Files and shapes are normalised, then scaled, rotated and translated", "[files]")
{
    const TemporaryFolder folder;
    folder.write("models/a.obj", triangleObj);
    const std::string mesh = "[[mesh]]\nfile = \"models/a.obj\"\n";
    const auto verticesOf = [&](const std::string& more) {
        return files::loadSceneFile(folder.write("a.toml", mesh + more)).scene.meshes.at(0).vertices;
    };
    CHECK(verticesOf("normalize = false\n")[0].position == glm::vec3(10, 0, 0));

    // The mean is (12, 1, 0), the farthest vertices lie sqrt(5) from it.
    const auto normalized = verticesOf("");
    CHECK(near(normalized[0].position, glm::vec3(-2, -1, 0) / std::sqrt(5.0f)));
    CHECK(near(normalized[2].position, glm::vec3(0, 2, 0) / std::sqrt(5.0f)));

    // A quarter turn about x takes y to z and z to -y.
    const auto placed = verticesOf("translate = [0, 5, 0]\nrotate = [90, 0, 0]\nscale = 2\n");
    CHECK(near(placed[2].position, glm::vec3(0, 5, 4 / std::sqrt(5.0f))));
    CHECK(near(placed[2].normal, glm::vec3(0, -1, 0)));

    const auto shape = files::loadSceneFile(folder.write("b.toml", "[[mesh]]\nshape = \"cube\"\n")).scene.meshes.at(0);
    for (const Vertex& vertex : shape.vertices)
        CHECK(glm::length(vertex.position) < 1.0f + rounding);
}

TEST_CASE("Keys of a mesh replace the materials of its file", "[files]")
{
    const TemporaryFolder folder;
    folder.write("a.tga", files_test::tinyTga());
    folder.write("m.mtl", "newmtl a\nKd 1 0 0\nNs 5\nmap_Kd a.tga\n");
    folder.write("a.obj", "mtllib m.mtl\nusemtl a\n" + triangleObj);
    const Scene scene = files::loadSceneFile(folder.write("a.toml", R"(
[[mesh]]
file = "a.obj"
[[mesh]]
file = "a.obj"
kd = [0, 1, 0]
[[mesh]]
triangles = [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]
texture = "a.tga"
)"))
                            .scene;
    REQUIRE(scene.meshes.size() == 3);
    REQUIRE(scene.textures.size() == 1); // named three times
    CHECK(scene.meshes[0].material.kdTexture == scene.textures[0].get());
    CHECK(scene.meshes[1].material.kd == glm::vec3(0, 1, 0));
    CHECK(scene.meshes[1].material.shininess == 5.0f);
    CHECK(scene.meshes[1].material.kdTexture == nullptr);
    CHECK(scene.meshes[2].material.kdTexture == scene.textures[0].get());
    CHECK(scene.meshes[2].material.kd == glm::vec3(0.8f));
    CHECK(scene.meshes[2].vertices[2].texCoord == glm::vec2(0, 1));
}

TEST_CASE("An OBJ file is a scene of its own", "[files]")
{
    const TemporaryFolder folder;
    const files::SceneFile file = files::loadSceneFile(folder.write("a.Obj", triangleObj));
    CHECK(near(file.scene.meshes.at(0).vertices[2].position, glm::vec3(0, 2, 0) / std::sqrt(5.0f)));
    CHECK(std::holds_alternative<PointLight>(file.scene.lights.at(0)));
    CHECK(file.config.features.enableShading);
    CHECK(file.config.features.enableAccelStructure);

    const Scene scene = loadSceneFromFile(folder / "a.Obj", { SegmentLight {} });
    CHECK(scene.meshes.at(0).vertices == file.scene.meshes[0].vertices);
    CHECK(scene.lights.size() == 1);
    CHECK(std::holds_alternative<SegmentLight>(scene.lights[0]));
}

TEST_CASE("A scene of the course is found by its type", "[files]")
{
    const auto [type, name] = GENERATE(table<SceneType, std::string>(
        { { SingleTriangle, "single_triangle" }, { Cube, "cube" }, { CubeTextured, "cube_textured" },
            { CornellBox, "cornell_box" }, { CornellBoxTransparency, "cornell_box_transparency" },
            { CornellBoxParallelogramLight, "cornell_box_parallelogram_light" }, { Monkey, "monkey" },
            { Teapot, "teapot" }, { Dragon, "dragon" }, { Spheres, "spheres" } }));
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(loadScenePrebuilt(type, folder / ""), Contains(name + ".toml: cannot be read"));
    folder.write(name + ".toml", "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n");
    const Scene scene = loadScenePrebuilt(type, folder / "");
    CHECK(scene.type == type);
    CHECK(scene.spheres.size() == 1);
}

TEST_CASE("A custom scene has no file to be found by its type", "[files]")
{
    CHECK_THROWS_AS(loadScenePrebuilt(SceneType::Custom, ""), std::invalid_argument);
}

TEST_CASE("A broken scene file is refused with its line", "[files]")
{
    const std::string sphere = "[[sphere]]\ncenter = [0, 0, 0]\nradius = ";
    const std::string mesh = "[[mesh]]\nshape = \"cube\"\n";
    const std::string size = "expected integers from 1 to 32768";
    const auto [text, message] = GENERATE_COPY(table<std::string, std::string>({
        { "\nsize = [1, 2\n", "a.toml:2: Error while parsing array" },
        { "size = [800]\n", "a.toml:1: found an array of 1, expected an array of 2 integers from 1 to 32768" },
        { "size = 800\n", "a.toml:1: found 800, expected an array of 2 integers from 1 to 32768" },
        { "size = [0, 0]\n", "a.toml:1: found 0, " + size },
        { "size = [800,\n32769]\n", "a.toml:2: found 32769, " + size },
        { "size = [1.5, 1]\n", "a.toml:1: found 1.5, " + size },
        { "\nsizes = [1, 1]\n",
            "a.toml:2: found the unknown key \"sizes\", expected one of size, camera, features, frame, mesh, sphere, "
            "light" },
        { "camera = 1\n", "a.toml:1: found 1, expected a table" },
        { "[camera]\nfov = 50\n", "a.toml:2: found the unknown key \"fov\", expected one of look_at, rotation" },
        { "[camera]\ndistance = nan\n", "a.toml:2: found nan, expected a number of at least 0" },
        { "[camera]\nlook_at = [0, inf, 0]\n", "a.toml:2: found inf, expected a number" },
        { "[camera]\nlook_at = [0, 0]\n", "a.toml:2: found an array of 2, expected an array of 3, each a number" },
        { "[camera]\nlook_at = [0, 0, 1e39]\n", "a.toml:2: found 1e+39, expected a number" },
        { "[camera]\nfield_of_view = 180\n", "a.toml:2: found 180, expected an angle between 0 and 180 degrees" },
        { "[frame]\nunit = 0\n", "a.toml:2: found 0, expected a number above 0" },
        { "[frame]\nscale = 1\n", "a.toml:2: found the unknown key \"scale\", expected one of origin, unit" },
        { "[features]\nshadow = true\n", "a.toml:2: found the unknown feature \"shadow\", expected one of shading," },
        { "[features]\nshading = 1\n", "a.toml:2: shading: found 1, expected true or false" },
        { "[features]\nshading = \"true\"\n", "a.toml:2: shading: found \"true\", expected true or false" },
        { "[features]\npixel_samples = 0\n", "a.toml:2: pixel_samples: found 0, expected a count from 1 to 1048576" },
        { "[features]\npixel_samples = 4.0\n", "a.toml:2: found 4, expected true, false, a count or a name" },
        { "[features]\nshading_model = \"flat\"\n", "a.toml:2: shading_model: found \"flat\", expected one of lamb" },
        { sphere + "-1\n", "a.toml:3: found -1, expected a number above 0" },
        { sphere + "\"1\"\n", "a.toml:3: found \"1\", expected a number above 0" },
        { sphere + "1979-05-27\n", "a.toml:3: found a date or a time" },
        { sphere + "1\nkd = [0, 1.5, 0]\n", "a.toml:4: found 1.5, expected a number in [0, 1]" },
        { sphere + "1\ntransparency = -0.1\n", "a.toml:4: found -0.1, expected a number in [0, 1]" },
        { sphere + "1\nshininess = -1\n", "a.toml:4: found -1, expected a number of at least 0" },
        { sphere + "1\ntexture = \"a.png\"\n", "a.toml:4: found the unknown key \"texture\"" },
        { "[[sphere]]\ncenter = [0, 0, 0]\n", "a.toml:1: found no radius, expected one" },
        { "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n", "a.toml:2: found the unknown key \"centre\"" },
        { "[sphere]\ncenter = [0, 0, 0]\n", "a.toml:1: found a table, expected tables [[sphere]]" },
        { "\n[[mesh]]\n", "a.toml:2: found 0 of file, shape, quads and triangles, expected exactly one" },
        { mesh + "file = \"a.obj\"\n", "a.toml:1: found 2 of file, shape, quads and triangles, expected exactly one" },
        { "[[mesh]]\nshape = \"ball\"\n", "a.toml:2: found \"ball\", expected one of " },
        { "[[mesh]]\nshape = 1\n", "a.toml:2: found 1, expected one of " },
        { "[[mesh]]\nfile = \"no.obj\"\n", "a.toml:2: " },
        { "[[mesh]]\nfile = \"bad.obj\"\n", "bad.obj:1: found \"x\", expected a number" },
        { mesh + "texture = \"no.png\"\n", "no.png: cannot be read, expected an existing file" },
        { mesh + "colour = 1\n",
            "a.toml:3: found the unknown key \"colour\", expected one of file, shape, quads, triangles, normalize, "
            "translate, rotate, scale, kd, ks, shininess, transparency, texture" },
        { mesh + "texture = 1\n", "a.toml:3: found 1, expected the name of a file" },
        { mesh + "scale = 0\n", "a.toml:3: found 0, expected a number above 0" },
        { mesh + "normalize = 1\n", "a.toml:3: found 1, expected true or false" },
        { "[[mesh]]\nquads = []\n", "a.toml:2: found an array of 0, expected quads, each an array of 4 points" },
        { "[[mesh]]\nquads = [\n[[0, 0, 0]]]\n", "a.toml:3: found an array of 1, expected an array of 4 points" },
        { "[[mesh]]\ntriangles = [[[0, 0, 0], [1, 1, 1], [2, 2, 2]]]\n",
            "a.toml:2: found points on a line, expected an area" },
        { "[[mesh]]\ntriangles = [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]\nnormalize = true\n",
            "a.toml:3: found the unknown key \"normalize\"" },
        { "[[light]]\ncolor = [1, 1, 1]\n", "a.toml:1: found a light without a type, expected the type \"point\"" },
        { "[[light]]\ntype = \"spot\"\n", "a.toml:2: found \"spot\", expected the type \"point\"" },
        { "[[light]]\ntype = \"point\"\ncolor = [1, 1, 1]\n", "a.toml:1: found no position, expected one" },
        { "[[light]]\ntype = \"point\"\nposition = [0, 0, 0]\ncolor = [-1, 0, 0]\n",
            "a.toml:4: found -1, expected a number of at least 0" },
    }));
    const TemporaryFolder folder;
    folder.write("bad.obj", "v x\n");
    INFO(text);
    CHECK_THROWS_WITH(files::loadSceneFile(folder.write("a.toml", text)), Contains(message));
    CHECK_THROWS_WITH(files::loadSceneFile(folder / "a.toml"), Contains("a.toml:"));
}

TEST_CASE("A scene in no known format is refused by name", "[files]")
{
    CHECK_THROWS_WITH(files::loadSceneFile("a.gltf"),
        EndsWith("found the extension \".gltf\", expected a scene in .toml or a model in .obj"));
    CHECK_THROWS_WITH(files::loadSceneFile("nowhere.toml"), Contains("nowhere.toml: cannot be read"));
}
