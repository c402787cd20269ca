#include "mesh_measures.h"
#include "shapes/shapes.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

namespace {

Mesh shape(std::string_view name)
{
    return shapes::makeShape(name).value();
}

bool isFinite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}

TEST_CASE("every shape that is named can be made, and no other", "[shapes]")
{
    for (const std::string_view name : shapes::shapeNames())
        CHECK(shapes::makeShape(name).has_value());
    CHECK_FALSE(shapes::makeShape("Cube").has_value());
    CHECK_FALSE(shapes::makeShape("").has_value());
}

TEST_CASE("every shape is made of sound vertices and triangles", "[shapes]")
{
    for (const std::string_view name : shapes::shapeNames()) {
        INFO(name);
        const Mesh mesh = shape(name);
        for (const Vertex& vertex : mesh.vertices) {
            REQUIRE(isFinite(vertex.position));
            // normalised in single precision: a few roundings of 6e-8
            REQUIRE(glm::length(glm::dvec3(vertex.normal)) == Approx(1.0).margin(5e-7));
            REQUIRE(glm::all(glm::greaterThanEqual(vertex.texCoord, glm::vec2(0.0f))));
            REQUIRE(glm::all(glm::lessThanEqual(vertex.texCoord, glm::vec2(1.0f))));
        }
        for (const glm::uvec3& triangle : mesh.triangles) {
            REQUIRE(glm::all(glm::lessThan(triangle, glm::uvec3(static_cast<glm::uint>(mesh.vertices.size())))));
            const auto [a, b, c] = measures::corners(mesh, triangle);
            const double longest = std::max({ glm::distance(a, b), glm::distance(b, c), glm::distance(c, a) });
            // a height of a thousandth of the longest side: far above rounding, so that the normal is known
            REQUIRE(glm::length(measures::areaNormal(mesh, triangle)) > 1e-3 * longest * longest);
        }
    }
}

TEST_CASE("normals of every shape are on the side from which its triangles run counter-clockwise", "[shapes]")
{
    for (const std::string_view name : shapes::shapeNames()) {
        INFO(name);
        const Mesh mesh = shape(name);
        std::size_t agree = 0;
        for (const glm::uvec3& triangle : mesh.triangles) {
            const glm::dvec3 side = measures::areaNormal(mesh, triangle);
            glm::dvec3 mean { 0.0 };
            for (int i = 0; i < 3; ++i)
                mean += glm::dvec3(mesh.vertices[triangle[i]].normal);
            agree += glm::dot(side, mean) > 0.0;
        }
        // all but the few at the tips of spikes, which are finer than the mesh
        CHECK(static_cast<double>(agree) >= 0.999 * static_cast<double>(mesh.triangles.size()));
    }
}

TEST_CASE("cube, monkey and dragon are closed: each edge has one triangle on each side", "[shapes]")
{
    for (const std::string_view name : { "cube", "monkey", "dragon" }) {
        INFO(name);
        const Mesh mesh = shape(name);
        const auto welded = measures::weld(mesh, 0.0);
        const auto edges = measures::directedEdges(mesh, welded);
        REQUIRE(measures::openEdges(edges).empty());
        REQUIRE(std::ranges::all_of(edges, [](const auto& entry) { return entry.second == 1; }));
        CHECK(measures::hasOneFanAtEachVertex(mesh, welded));
        CHECK(measures::signedVolume(mesh) > 0.0);
    }
}

TEST_CASE("the cube has flat faces of two by two with the texture once on each", "[shapes]")
{
    const Mesh cube = shape("cube");
    CHECK(cube.vertices.size() == 24);
    CHECK(measures::signedVolume(cube) == Approx(8.0));
    for (const glm::uvec3& triangle : cube.triangles) {
        const Vertex &a = cube.vertices[triangle.x], &b = cube.vertices[triangle.y], &c = cube.vertices[triangle.z];
        CHECK(measures::areaNormal(cube, triangle) == 4.0 * glm::dvec3(a.normal));
        const glm::vec2 u = b.texCoord - a.texCoord, v = c.texCoord - a.texCoord;
        CHECK(u.x * v.y - u.y * v.x == 1.0f); // half the texture, not mirrored
    }
}

TEST_CASE("shapes have about as many triangles as they promise", "[shapes]")
{
    const auto count = [](std::string_view name) { return shape(name).triangles.size(); };
    CHECK(count("triangle") == 1);
    CHECK(count("cube") == 12);
    CHECK((count("monkey") > 800 && count("monkey") < 1400));
    CHECK((count("teapot") > 13'000 && count("teapot") < 17'000));
    CHECK((count("dragon") > 90'000 && count("dragon") < 110'000));
}

TEST_CASE("the monkey is as good as symmetric", "[shapes]")
{
    const Mesh monkey = shape("monkey");
    for (const Vertex& vertex : monkey.vertices) {
        const glm::vec3 mirrored = vertex.position * glm::vec3(-1.0f, 1.0f, 1.0f);
        const auto apart = [&](const Vertex& other) { return glm::distance(other.position, mirrored); };
        // a cell's width, 0.2: the halves melt in one after the other
        CHECK(std::ranges::min(monkey.vertices, {}, apart).position.x == Approx(mirrored.x).margin(0.1));
    }
}
