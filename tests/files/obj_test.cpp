#include "files/error.h"
#include "files/obj.h"
#include "temporary_folder.h"
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <set>

using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using files_test::TemporaryFolder;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Scene load(const std::filesystem::path& path)
{
    Scene scene;
    files::loadObj(path, scene);
    return scene;
}

Mesh loadMesh(const std::filesystem::path& path)
{
    return load(path).meshes.at(0);
}

double areaOf(const Mesh& mesh)
{
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 p = mesh.vertices[t.x].position;
        area += glm::length(glm::cross(
                    glm::dvec3(mesh.vertices[t.y].position) - p, glm::dvec3(mesh.vertices[t.z].position) - p))
            / 2.0;
    }
    return area;
}

}

TEST_CASE("A polygon becomes triangles of the same area", "[files]")
{
    const TemporaryFolder folder;
    const Scene scene = load(folder.write("a.obj", square + "v -0.5 0.5 0\nf 1 2 3 4 5\n"));
    REQUIRE(scene.meshes.size() == 1);
    CHECK(scene.meshes[0].triangles.size() == 3);
    CHECK(areaOf(scene.meshes[0]) == Approx(1.25)); // the unit square and a triangle of 1/4
}

TEST_CASE("A concave polygon whose first corner sees all others becomes triangles of the same area", "[files]")
{
    const TemporaryFolder folder;
    const std::string angle = "v -10 7 0\nv -8 7 0\nv -8 8 0\nv -9 8 0\nv -9 9 0\nv -10 9 0\n";
    const Mesh mesh = loadMesh(folder.write("a.obj", angle + "f 1 2 3 4 5 6\n"));
    CHECK(mesh.triangles.size() == 4);
    CHECK(areaOf(mesh) == Approx(3.0)); // of squares
}

TEST_CASE("A quad is cut along its shorter diagonal, also if a corner comes after it", "[files]")
{
    const TemporaryFolder folder;
    const Mesh mesh = loadMesh(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3 4\nv 3 1 0\nv 0 1 0\n"));
    REQUIRE(mesh.triangles.size() == 2);
    for (const glm::uvec3& triangle : mesh.triangles) {
        std::set<float> x;
        for (int i = 0; i < 3; ++i)
            x.insert(mesh.vertices[triangle[i]].position.x);
        CHECK(x.contains(1.0f)); // of the second corner, an end of the diagonal
    }
}

TEST_CASE("Whoever looks on sees the whole file being read", "[files]")
{
    const TemporaryFolder folder;
    values::Progress progress;
    CHECK(progress.fraction() == 0.0f);
    Scene scene;
    files::loadObj(folder.write("a.obj", square + "f 1 2 3\r\n\nf 1 3 4"), scene, progress);
    CHECK(progress.fraction() == 1.0f);
}

TEST_CASE("Corners with equal indices share a vertex, others do not", "[files]")
{
    const TemporaryFolder folder;
    CHECK(loadMesh(folder.write("a.obj", square + "f 1 2 3\nf 1 3 4\n")).vertices.size() == 4);
    const std::string two = square + "vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//1\n";
    CHECK(loadMesh(folder.write("b.obj", two)).vertices.size() == 5);
}

TEST_CASE("Negative indices count from the last element so far", "[files]")
{
    const TemporaryFolder folder;
    const Scene scene = load(folder.write("a.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.5\nf -3/-1 -2/-1 -1/-1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf -3 -2 -1\r\n"));
    const Mesh& mesh = scene.meshes[0];
    CHECK(mesh.vertices[mesh.triangles[0].y].position == glm::vec3(1, 0, 0));
    CHECK(mesh.vertices[mesh.triangles[0].y].texCoord == glm::vec2(0.25f, 0.5f));
    CHECK(mesh.vertices[mesh.triangles[1].y].position == glm::vec3(6, 0, 0));
}

TEST_CASE("Missing normals are the area-weighted mean around a position", "[files]")
{
    const TemporaryFolder folder;
    // Along the x axis a triangle of area 1/2 that faces +z meets one of area 3/2 that faces +y.
    const Scene scene
        = load(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -3\nf 1 2 3\nf 2 4 1\nf 1 2 3\nf 3 2 1\n"));
    for (const Vertex& vertex : scene.meshes[0].vertices) {
        CHECK(glm::length(vertex.normal) == Approx(1.0f));
        if (vertex.position == glm::vec3(1, 0, 0)) {
            const glm::vec3 expected = glm::normalize(glm::vec3(0, 3, 1));
            CHECK(glm::distance(vertex.normal, expected) == Approx(0.0f).margin(1e-6f)); // rounding of floats
        }
    }
}

TEST_CASE("Normals are unit, whatever the file says", "[files]")
{
    const TemporaryFolder folder;
    const std::string text = square + "vn 0 0 5\nvn 0 0 0\nf 1//1 2//1 3//2\n";
    for (const Vertex& vertex : loadMesh(folder.write("a.obj", text)).vertices)
        CHECK(vertex.normal == glm::vec3(0, 0, 1));
    // Two sides of a sheet cancel; far too large for the square of a float.
    for (const char* corners : { "f 1 2 3\nf 3 2 1\n", "v 1e30 0 0\nv 0 1e30 0\nf 1 5 6\n" })
        for (const Vertex& vertex : loadMesh(folder.write("b.obj", square + corners)).vertices)
            CHECK(glm::length(vertex.normal) == Approx(1.0f));
}

TEST_CASE("Materials in use become meshes with what the MTL file says", "[files]")
{
    const TemporaryFolder folder;
    folder.write("models/pictures/a.tga", files_test::tinyTga());
    folder.write("models/m.mtl",
        "newmtl red\nKd 1 0 0\nKs 0.5 0.25 0\nNs 20\nd 0.5\nTr 0.1\nnewmtl unused\nmap_Kd nothing.png\n"
        "newmtl wood\nmap_Kd pictures\\a.tga\nTr 0.25\nnewmtl wood2\nmap_Kd -clamp on pictures/../pictures/a.tga\n");
    const Scene scene = load(folder.write("models/a.obj",
        "mtllib m.mtl\n" + square
            + "f 1 2 3\nusemtl wood\nf 1 2 3\nusemtl red\nf 1 2 3 4\nusemtl wood2\nf 2 3 4\nusemtl wood\nf 1 2 4\n"));
    REQUIRE(scene.meshes.size() == 4);
    std::set<std::size_t> sizes;
    for (const Mesh& mesh : scene.meshes) {
        const Material& material = mesh.material;
        if (material.kd == glm::vec3(0.8f)) { // before any usemtl
            CHECK(mesh.triangles.size() == 1);
        } else if (material.kd == glm::vec3(1, 0, 0)) {
            CHECK(mesh.triangles.size() == 2);
            CHECK(material.ks == glm::vec3(0.5f, 0.25f, 0.0f));
            CHECK(material.shininess == 20.0f);
            CHECK(material.transparency == 0.5f);
            CHECK(material.kdTexture == nullptr);
        } else {
            REQUIRE(scene.textures.size() == 1); // one file, named twice
            CHECK(material.kdTexture == scene.textures[0].get());
            CHECK((material.transparency == 0.75f) == (mesh.triangles.size() == 2)); // wood, wood2
        }
    }
}

TEST_CASE("A missing MTL file leaves light grey", "[files]")
{
    const TemporaryFolder folder;
    const Scene scene = load(folder.write("a.obj", "mtllib no.mtl\nusemtl red\n" + square + "f 1 2 3\n"));
    REQUIRE(scene.meshes.size() == 1);
    CHECK(scene.meshes[0].material.kd == glm::vec3(0.8f));
}

TEST_CASE("A broken OBJ file is refused with its line", "[files]")
{
    const auto [name, text, message] = GENERATE(table<std::string, std::string, std::string>({
        { "empty", "", "a.obj: found no faces, expected at least one" },
        { "no faces", square, "a.obj: found no faces, expected at least one" },
        { "above", square + "f 1 2 5\n", "a.obj:5: found the index 5, expected 1 to 4 or -4 to -1 of the positions" },
        { "below", square + "\nf 1 2 -5\n",
            "a.obj:6: found the index -5, expected 1 to 4 or -4 to -1 of the positions" },
        { "zero", square + "f 0 1 2\n", "a.obj:5: found the index 0, expected 1 to 4 or -4 to -1 of the positions" },
        { "huge", square + "f 1 2 99999999999\n",
            "a.obj:5: found the index 99999999999, expected 1 to 4 or -4 to -1 of the positions" },
        { "normal", square + "f 1//1 2//1 3//1\n",
            "a.obj:5: found the index 1, expected none as there are no normals" },
        { "texture", square + "vt 0 0\nf 1/1 2/2 3/1\n",
            "a.obj:6: found the index 2, expected 1 to 1 or -1 to -1 of the texture coordinates" },
        { "word", square + "f 1 two 3\n", "a.obj:5: found \"two\", expected indices as 1, 1/1, 1/1/1 or 1//1" },
        { "slash", square + "f 1 2/ 3\n", "a.obj:5: found \"2/\", expected indices as 1, 1/1, 1/1/1 or 1//1" },
        { "four", square + "f 1 2/1/1/1 3\n", "expected indices as 1, 1/1, 1/1/1 or 1//1" },
        { "corners", square + "f 1 2\n", "a.obj:5: found a face of 2 corners, expected at least 3" },
        { "nan", "v 0 0 nan\n", "a.obj:1: found \"nan\", expected a number" },
        { "infinite", "v 0 0 0\r\nv 1e999 0 0\r\n", "a.obj:2: found \"1e999\", expected a number" },
        { "beyond float", "v 0 0 1e39\n", "a.obj:1: found \"1e39\", expected a number" },
        { "short", "v 0 0\n", "a.obj:1: found the end of the line, expected a number" },
        { "normal number", square + "vn 0 x 0\n", "a.obj:5: found \"x\", expected a number" },
        { "overflow", square + "v 0 0 0e999\nf 1 2 3\n",
            "a.obj:5: found a number out of range, expected a finite one" },
        { "concave, others after it",
            "v -10 7 0\nv -8 7 0\nv -8 8 0\nv -9 8 0\nv -9 9 0\nv -10 9 0\nf 6 5 4 3 2 1\n" + square
                + "f 7 8 9\nf 7 8 9\nf 7 8 9\n",
            "a.obj:7: found a face of 6 corners that cannot be triangulated, expected a convex face or triangles" },
        { "concave, reversed", "v -10 7 0\nv -8 7 0\nv -8 8 0\nv -9 8 0\nv -9 9 0\nv -10 9 0\nf 6 5 4 3 2 1\n",
            "a.obj:7: found a face of 6 corners that cannot be triangulated, expected a convex face or triangles" },
    }));
    const TemporaryFolder folder;
    INFO(name);
    CHECK_THROWS_WITH(load(folder.write("a.obj", text)), EndsWith(message));
}

TEST_CASE("A broken MTL file is refused with its line", "[files]")
{
    const auto [text, message] = GENERATE(table<std::string, std::string>({
        { "Kd 1 1 1\n", "m.mtl:1: found Kd, expected newmtl before it" },
        { "newmtl a\nKd 1 nan 1\n", "m.mtl:2: found \"nan\", expected a number in [0, 1]" },
        { "newmtl a\nKd\n", "m.mtl:2: found the end of the line, expected a number in [0, 1]" },
        { "newmtl a\nKs 0 0 2\n", "m.mtl:2: found \"2\", expected a number in [0, 1]" },
        { "newmtl a\n\nNs -1\n", "m.mtl:3: found \"-1\", expected a number of at least 0" },
        { "newmtl a\nd 1.5\n", "m.mtl:2: found \"1.5\", expected a number in [0, 1]" },
        { "newmtl a\nmap_Kd\n", "m.mtl:2: found map_Kd without a name, expected that of a picture" },
        { "newmtl a\nmap_Kd no.png\n", "no.png: cannot be read, expected an existing file" },
    }));
    const TemporaryFolder folder;
    folder.write("m.mtl", text);
    const auto path = folder.write("a.obj", "mtllib m.mtl\nusemtl a\n" + square + "f 1 2 3\n");
    CHECK_THROWS_WITH(load(path), EndsWith(message));
    if (text.ends_with("no.png\n"))
        CHECK_THROWS_WITH(load(path), Contains("m.mtl:2: map_Kd: "));
}

TEST_CASE("A missing OBJ file is refused by name", "[files]")
{
    CHECK_THROWS_WITH(load("nowhere/a.obj"), EndsWith("a.obj: cannot be read, expected an existing file"));
}
