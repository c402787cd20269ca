#include "accel/builder.h"
#include "bvh.h"
#include "grading/oracle/random_scene.h"
#include <catch2/catch.hpp>
#include <map>

using grading::Random;
using Node = BVHInterface::Node;
using Primitive = BVHInterface::Primitive;

namespace {

constexpr uint32_t leafSize = BVH::LeafSize;

bool contains(const AxisAlignedBox& box, const glm::vec3& p)
{
    return glm::all(glm::lessThanEqual(box.lower, p)) && glm::all(glm::lessThanEqual(p, box.upper));
}

// What a walk through the whole tree finds.
struct Walk {
    const accel::Tree& tree;
    uint32_t numLevels = 0, numLeaves = 0;
    std::vector<int> nodeVisits, primitiveVisits;

    explicit Walk(const accel::Tree& tree_)
        : tree(tree_)
        , nodeVisits(tree.nodes.size())
        , primitiveVisits(tree.primitives.size())
    {
        visit(0, 1);
    }

    void visit(uint32_t index, uint32_t level)
    {
        REQUIRE(index < tree.nodes.size());
        REQUIRE(nodeVisits[index]++ == 0);
        REQUIRE(level <= accel::maxLevels);
        numLevels = std::max(numLevels, level);
        const Node& node = tree.nodes[index];
        if (node.isLeaf())
            return visitLeaf(node);
        for (const uint32_t child : node.data) {
            visit(child, level + 1);
            CHECK(contains(node.aabb, tree.nodes[child].aabb.lower));
            CHECK(contains(node.aabb, tree.nodes[child].aabb.upper));
        }
    }

    void visitLeaf(const Node& leaf)
    {
        ++numLeaves;
        CHECK(leaf.primitiveCount() >= 1);
        CHECK(leaf.primitiveCount() <= leafSize);
        for (uint32_t i = leaf.primitiveOffset(); i < leaf.primitiveOffset() + leaf.primitiveCount(); ++i) {
            REQUIRE(i < tree.primitives.size());
            ++primitiveVisits[i];
            for (const Vertex& vertex : { tree.primitives[i].v0, tree.primitives[i].v1, tree.primitives[i].v2 })
                CHECK(contains(leaf.aabb, vertex.position));
        }
    }
};

using Positions = std::array<float, 10>;

// How often each triangle occurs, by its mesh and its corners.
using Count = std::map<Positions, int>;

void count(Count& counts, uint32_t meshID, const Vertex& v0, const Vertex& v1, const Vertex& v2)
{
    const glm::vec3 &a = v0.position, &b = v1.position, &c = v2.position;
    ++counts[{ static_cast<float>(meshID), a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z }];
}

void checkTree(const Scene& scene)
{
    const accel::Tree tree = accel::buildTree(scene, leafSize);
    const Walk walk(tree);
    CHECK(walk.numLevels == tree.numLevels);
    CHECK(walk.numLeaves == tree.numLeaves);
    CHECK(std::ranges::all_of(walk.nodeVisits, [](int visits) { return visits == 1; }));
    CHECK(std::ranges::all_of(walk.primitiveVisits, [](int visits) { return visits == 1; }));
    Count inScene, inTree;
    for (uint32_t meshID = 0; meshID < scene.meshes.size(); ++meshID)
        for (const glm::uvec3& t : scene.meshes[meshID].triangles) {
            const auto& vertices = scene.meshes[meshID].vertices;
            count(inScene, meshID, vertices[t.x], vertices[t.y], vertices[t.z]);
        }
    for (const Primitive& p : tree.primitives)
        count(inTree, p.meshID, p.v0, p.v1, p.v2);
    CHECK(inScene == inTree);
}

Scene sceneOf(std::vector<std::array<glm::vec3, 3>> triangles)
{
    Scene scene;
    scene.meshes.emplace_back();
    for (const auto& [a, b, c] : triangles)
        grading::addTriangle(scene.meshes[0], { Vertex { a, {}, {} }, Vertex { b, {}, {} }, Vertex { c, {}, {} } });
    return scene;
}

}

TEST_CASE("The builder puts every triangle into one leaf of 1 to 4, in boxes that contain what is below", "[builder]")
{
    Random random(1, "builder");
    for (const int numTriangles : { 1, 2, 3, 4, 5, 6, 17, 100, 3000 }) {
        CAPTURE(numTriangles);
        Scene scene;
        grading::addTriangles(scene, random, numTriangles);
        checkTree(scene);
    }
}

TEST_CASE("The builder splits where coinciding and degenerate triangles leave nothing to split by", "[builder]")
{
    const glm::vec3 a { 0, 0, 0 }, b { 1, 0, 0 }, c { 0, 1, 0 };
    for (const std::size_t numTriangles : { 4u, 5u, 33u, 1000u }) {
        checkTree(sceneOf({ numTriangles, { a, b, c } }));
        checkTree(sceneOf({ numTriangles, { a, a, a } }));
        checkTree(sceneOf({ numTriangles, { a, b, b } }));
    }
}

TEST_CASE("The builder stays within its levels where each split takes off one triangle", "[builder]")
{
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (int i = 0; i < 120; ++i) { // each twice as far and as large as the one before
        const float size = std::ldexp(1.0f, i - 60);
        triangles.push_back(
            { glm::vec3(size), glm::vec3(1.5f * size, size, size), glm::vec3(size, 1.5f * size, size) });
    }
    checkTree(sceneOf(triangles));
    checkTree(sceneOf({ 3000, triangles.front() }));
}

TEST_CASE("A scene without triangles gives an empty tree that no ray meets", "[builder]")
{
    for (const Scene& scene : { Scene {}, sceneOf({}) }) {
        const Features features { .enableAccelStructure = false };
        const BVH bvh(scene, features);
        CHECK(bvh.primitives().empty());
        CHECK(bvh.numLevels() == 1);
        CHECK(bvh.numLeaves() == 1);
        RenderState state { scene, features, bvh, Sampler(1) };
        for (const glm::vec3& direction : { glm::vec3(0, 0, -1), glm::vec3(1, 2, 3) }) {
            Ray ray { glm::vec3(0.0f), direction };
            HitInfo hit;
            CHECK_FALSE(intersectRayWithBVH(state, bvh, ray, hit));
            CHECK(ray.t == FLT_MAX);
        }
    }
}

TEST_CASE("A node says whether it is a leaf, and which are its primitives or children", "[builder]")
{
    const Node leaf { {}, { Node::LeafBit | 12u, 3u } }, inner { {}, { 12u, 13u } };
    CHECK(leaf.isLeaf());
    CHECK(leaf.primitiveOffset() == 12);
    CHECK(leaf.primitiveCount() == 3);
    CHECK_FALSE(inner.isLeaf());
    CHECK(inner.leftChild() == 12);
    CHECK(inner.rightChild() == 13);
}

TEST_CASE("Primitives are made when somebody looks, and one alone is the same before and after", "[builder]")
{
    Random random(1, "primitives");
    Scene scene;
    for (int i = 0; i < 3; ++i)
        grading::addTriangles(scene, random, 50);
    const accel::Tree tree = accel::buildTree(scene, leafSize);
    const auto oneByOne = [&] {
        std::vector<Primitive> primitives;
        for (Primitive room; primitives.size() < tree.primitives.size();)
            primitives.push_back(tree.primitives.at(primitives.size(), room));
        return primitives;
    };
    const std::vector<Primitive> before = oneByOne();
    CHECK(before.size() == 150);
    CHECK(tree.primitives.all() == before);
    CHECK(oneByOne() == before);
}

TEST_CASE("Whoever builds a tree of their own fills its primitives like a vector", "[builder]")
{
    BVHPrimitives primitives;
    const std::vector<Primitive> some(3, Primitive { 7, {}, {}, {} });
    std::ranges::copy(some, std::back_inserter(primitives));
    primitives.push_back({ 8, {}, {}, {} });
    CHECK(primitives.size() == 4);
    CHECK(primitives[2].meshID == 7);
    CHECK(primitives[3].meshID == 8);
    CHECK(std::span<const Primitive>(primitives).size() == 4);
}
