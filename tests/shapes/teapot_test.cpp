#include "mesh_measures.h"
#include "shapes/shapes.h"
#include "shapes/teapot_patches.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

namespace {

const Mesh& teapot()
{
    static const Mesh mesh = shapes::makeShape("teapot").value();
    return mesh;
}

// Vertices that patches share are computed once by each of them, from control points of at most 4: the tolerance is
// some roundings of 2e-7, a hundredth of the shortest edge.
const std::vector<std::size_t>& welded()
{
    static const std::vector<std::size_t> indices = measures::weld(teapot(), 4e-6);
    return indices;
}

// The lengths, in edges, of the closed lines that the edges form.
std::multiset<std::size_t> loopLengths(const std::vector<measures::Edge>& edges)
{
    std::map<std::size_t, std::size_t> next;
    for (const auto& [from, to] : edges)
        next[from] = to;
    std::multiset<std::size_t> lengths;
    while (!next.empty()) {
        std::size_t length = 0;
        for (auto at = next.begin(); at != next.end(); ++length) {
            const std::size_t to = at->second;
            next.erase(at);
            at = next.find(to);
        }
        lengths.insert(length);
    }
    return lengths;
}

}

TEST_CASE("the teapot has the 32 patches and the extent of Newell's", "[shapes]")
{
    CHECK(shapes::teapotPatches().size() == 32);
    glm::vec3 lower { 1e9f }, upper { -1e9f };
    for (const Vertex& vertex : teapot().vertices) {
        lower = glm::min(lower, vertex.position);
        upper = glm::max(upper, vertex.position);
    }
    CHECK(lower.x == Approx(-3.0f)); // the handle
    CHECK(upper.x == Approx(3.434f).margin(0.005)); // the spout's lip, which bulges most between two vertices
    CHECK(lower.y == Approx(0.0f).margin(1e-6));
    CHECK(upper.y == Approx(3.15f)); // the knob
    CHECK(lower.z == Approx(-2.0f)); // the body
    CHECK(upper.z == Approx(2.0f));
}

TEST_CASE("the teapot is open at the rim, the lid and both ends of handle and spout, and nowhere else", "[shapes]")
{
    const auto edges = measures::directedEdges(teapot(), welded());
    CHECK(std::ranges::all_of(edges, [](const auto& entry) { return entry.second == 1; }));
    // rings of four patches, hoops of two, 15 edges along each
    CHECK(loopLengths(measures::openEdges(edges)) == std::multiset<std::size_t> { 30, 30, 30, 30, 60, 60 });
}

TEST_CASE("the teapot's normals point outwards, also where a patch collapses to a point", "[shapes]")
{
    CHECK(measures::signedVolume(teapot()) > 0.0);
    std::size_t poles = 0;
    for (const Vertex& vertex : teapot().vertices) {
        const bool onAxis = glm::length(glm::vec2(vertex.position.x, vertex.position.z)) == 0.0f;
        if (!onAxis)
            continue;
        const glm::vec3 expected { 0.0f, vertex.position.y > 1.0f ? 1.0f : -1.0f, 0.0f };
        CHECK(glm::distance(vertex.normal, expected) < 1e-6f); // single precision's rounding of a unit vector
        ++poles;
    }
    CHECK(poles == 2 * 4 * 16); // knob and bottom, four patches each, 16 vertices along each edge
}

TEST_CASE("patches that meet at the same vertex agree about the normal where the teapot is smooth", "[shapes]")
{
    // The body below the rim: inside a profile and across the seams of its four quarters.
    for (std::size_t i = 0; i < teapot().vertices.size(); ++i) {
        const Vertex &vertex = teapot().vertices[i], &first = teapot().vertices[welded()[i]];
        if (vertex.position.y < 2.3f && vertex.position.y > 0.2f && glm::abs(vertex.position.x) < 1.9f)
            CHECK(glm::dot(vertex.normal, first.normal) > 0.99f); // about 8 degrees, a circle of four cubics
    }
}
