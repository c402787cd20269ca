#include "bvh.h"
#include "grading/oracle/brute_force.h"
#include "grading/oracle/random_scene.h"
#include "shapes/shapes.h"
#include "world.h"
#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numeric>
#include <random>

using namespace tests;
using grading::Random;

namespace {

// Distances of about 1 to 5 between rounded corners of triangles that are no slivers, met at no grazing angle.
constexpr double distanceRounding = 1e-4;

// Every test of a traversal asks both: the reference's and the library's own.
Features withAccelStructure(bool enable)
{
    return { .enableAccelStructure = enable };
}

Scene randomScene(Random& random, int numTriangles, int numSpheres)
{
    Scene scene;
    grading::addTriangles(scene, random, numTriangles);
    grading::addSpheres(scene, random, numSpheres);
    return scene;
}

// Towards the scene, from inside or around it; some end before they get there.
Ray randomRay(Random& random)
{
    const glm::vec3 origin = random.uniform(0.0f, 3.0f) * random.direction();
    const glm::vec3 target = random.vec3(-1.0f, 1.0f);
    const Ray ray { origin, random.uniform(0.3f, 3.0f) * glm::normalize(target - origin) };
    return random.integer(0, 3) > 0 ? ray : Ray { ray.origin, ray.direction, random.uniform(0.0f, 2.0f) };
}

struct Answer {
    bool isHit = false;
    Ray ray;
    HitInfo hit {};
};

Answer ask(World& world, const Ray& ray)
{
    Answer answer { .ray = ray };
    answer.isHit = world.bvh.intersect(world.state, answer.ray, answer.hit);
    return answer;
}

// The interpolated texture coordinates or normal at a hit, in double precision.
template <typename Vector, typename Member> Vector interpolated(const grading::SceneHit& hit, Member Vertex::*member)
{
    Vector sum { 0.0 };
    for (int i = 0; i < 3; ++i)
        sum += hit.barycentric[i] * Vector(hit.mesh->vertices[hit.triangle[i]].*member);
    return sum;
}

void checkAttributes(const Answer& answer, const grading::SceneHit& expected, bool interpolateNormals)
{
    constexpr double slenderRounding = 1e-4; // heights are a tenth of the edges at least
    CHECK(answer.hit.material.kd == expected.material->kd);
    CHECK(std::abs(glm::length(answer.hit.normal) - 1.0f) < 1e-6f);
    CHECK(glm::dot(answer.hit.normal, answer.ray.direction) <= 0.0f);
    if (!expected.mesh) {
        CHECK(answer.hit.texCoord == glm::vec2(0.0f));
        return;
    }
    CHECK(distance(answer.hit.barycentricCoord, expected.barycentric) < slenderRounding);
    CHECK(glm::distance(glm::dvec2(answer.hit.texCoord), interpolated<glm::dvec2>(expected, &Vertex::texCoord))
        < slenderRounding);
    const glm::dvec3 normal
        = interpolateNormals ? glm::normalize(interpolated<glm::dvec3>(expected, &Vertex::normal)) : expected.normal;
    CHECK(std::abs(glm::dot(normal, glm::dvec3(answer.hit.normal))) == Approx(1.0).margin(slenderRounding));
}

Scene closedScene(const std::string& shape)
{
    Scene scene;
    scene.meshes.push_back(shapes::makeShape(shape).value());
    return scene;
}

}

TEST_CASE("BVH, equals brute force", "[bvh]")
{
    const bool accel = GENERATE(true, false);
    const bool interpolateNormals = GENERATE(true, false);
    Random random(1, "brute force");
    int numHits = 0, numMisses = 0;
    for (const int numTriangles : { 0, 1, 5, 60, 400 }) {
        World world(randomScene(random, numTriangles, numTriangles % 7), withAccelStructure(accel));
        world.features.enableNormalInterp = interpolateNormals;
        for (int i = 0; i < 300; ++i) {
            const Ray ray = randomRay(random);
            const grading::SceneHit expected = grading::closestHit(world.scene, ray);
            if (!expected.isClear)
                continue;
            const Answer answer = ask(world, ray);
            REQUIRE(answer.isHit == expected.isHit);
            (expected.isHit ? numHits : numMisses) += 1;
            if (!expected.isHit)
                continue;
            const double length = glm::length(glm::dvec3(ray.direction));
            CHECK(std::abs(static_cast<double>(answer.ray.t) - expected.t) * length < distanceRounding);
            checkAttributes(answer, expected, interpolateNormals);
        }
    }
    CHECK(numHits > 100); // neither is tested by accident only
    CHECK(numMisses > 100);
}

TEST_CASE("BVH, both traversals find the same distance, bit for bit", "[bvh]")
{
    Random random(1, "both");
    World mine(randomScene(random, 500, 3), withAccelStructure(true));
    World theirs(mine.scene, withAccelStructure(false));
    for (int i = 0; i < 3000; ++i) {
        const Ray ray = randomRay(random);
        const Answer a = ask(mine, ray), b = ask(theirs, ray);
        CHECK(a.isHit == b.isHit);
        CHECK(a.ray.t == b.ray.t);
    }
}

TEST_CASE("BVH, a miss changes neither ray nor hit", "[bvh]")
{
    const bool accel = GENERATE(true, false);
    Random random(1, "miss");
    World world(randomScene(random, 50, 2), withAccelStructure(accel));
    for (int i = 0; i < 500; ++i) {
        Ray ray = randomRay(random);
        const float end = ray.t;
        HitInfo hit;
        hit.normal = hit.barycentricCoord = glm::vec3(7.0f);
        hit.texCoord = glm::vec2(7.0f);
        hit.material.kd = glm::vec3(7.0f);
        if (world.bvh.intersect(world.state, ray, hit))
            continue;
        CHECK(ray.t == end);
        for (const glm::vec3& v : { hit.normal, hit.barycentricCoord, hit.material.kd })
            CHECK(v == glm::vec3(7.0f));
        CHECK(hit.texCoord == glm::vec2(7.0f));
    }
}

TEST_CASE("BVH, a ray that ends at its hit meets it, one that ends before does not", "[bvh]")
{
    const bool accel = GENERATE(true, false);
    Random random(1, "ends");
    World world(randomScene(random, 100, 3), withAccelStructure(accel));
    for (int i = 0; i < 1000; ++i) {
        Ray ray = randomRay(random);
        const Answer answer = ask(world, ray);
        if (!answer.isHit)
            continue;
        ray.t = answer.ray.t;
        CHECK(ask(world, ray).isHit);
        ray.t = std::nextafter(answer.ray.t, 0.0f);
        CHECK_FALSE(ask(world, ray).isHit);
    }
}

TEST_CASE("BVH, the order of triangles and meshes does not matter", "[bvh]")
{
    const bool accel = GENERATE(true, false);
    Random random(1, "order");
    World world(randomScene(random, 300, 3), withAccelStructure(accel));
    Scene shuffled = world.scene;
    std::mt19937 engine(1);
    std::shuffle(shuffled.meshes.begin(), shuffled.meshes.end(), engine);
    for (Mesh& mesh : shuffled.meshes)
        std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), engine);
    World other(std::move(shuffled), withAccelStructure(accel));
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = randomRay(random);
        const Answer a = ask(world, ray), b = ask(other, ray);
        CHECK(a.isHit == b.isHit);
        CHECK(a.ray.t == b.ray.t);
        if (a.isHit)
            CHECK(a.hit.material.kd == b.hit.material.kd);
    }
}

TEST_CASE("BVH, moving and turning scene and ray together leaves the hit where it was", "[bvh]")
{
    const bool accel = GENERATE(true, false);
    Random random(1, "motion");
    World world(randomScene(random, 100, 3), withAccelStructure(accel));
    const glm::quat turn = glm::angleAxis(2.0f, glm::normalize(glm::vec3(1, 2, 3)));
    const glm::vec3 shift { 0.5f, -1.0f, 0.25f };
    Scene moved = world.scene;
    for (Mesh& mesh : moved.meshes)
        for (Vertex& vertex : mesh.vertices)
            vertex.position = turn * vertex.position + shift;
    for (Sphere& sphere : moved.spheres)
        sphere.center = turn * sphere.center + shift;
    World other(std::move(moved), withAccelStructure(accel));
    for (int i = 0; i < 1000; ++i) {
        const Ray ray = randomRay(random);
        if (!grading::closestHit(world.scene, ray).isClear)
            continue;
        const Answer a = ask(world, ray), b = ask(other, { turn * ray.origin + shift, turn * ray.direction, ray.t });
        REQUIRE(a.isHit == b.isHit);
        if (!a.isHit)
            continue;
        CHECK(std::abs(a.ray.t - b.ray.t) * glm::length(ray.direction) < static_cast<float>(distanceRounding));
        CHECK(distance(turn * a.hit.normal, glm::dvec3(b.hit.normal)) < 1e-3); // of spheres of 0.1 at distances of 3
    }
}

TEST_CASE("BVH, no ray from inside slips through an edge of a closed mesh", "[bvh]")
{
    const bool accel = GENERATE(true, false);
    World world(closedScene(GENERATE("cube", "monkey")), withAccelStructure(accel)); // the origin lies inside
    const Mesh& mesh = world.scene.meshes.front();
    Random random(1, "watertight");
    for (std::size_t i = 0; i < 4000; ++i) {
        const glm::uvec3& triangle = mesh.triangles[i * 7919 % mesh.triangles.size()];
        const glm::vec3 a = mesh.vertices[triangle[0]].position, b = mesh.vertices[triangle[1]].position;
        const glm::vec3 inside = 0.1f * random.vec3(-1.0f, 1.0f);
        for (const float along : { 0.5f, random.uniform(0.01f, 0.99f) })
            CHECK(ask(world, { inside, glm::mix(a, b, along) - inside }).isHit);
    }
}

TEST_CASE("BVH, rays along an axis meet a grid on its lines and corners, whichever the sign of zero", "[bvh]")
{
    const bool accel = GENERATE(true, false);
    const int axis = GENERATE(0, 1, 2);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Scene scene;
    constexpr int cells = 8;
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            glm::vec3 corner { 0.0f }, edgeU { 0.0f }, edgeV { 0.0f };
            corner[u] = static_cast<float>(i);
            corner[v] = static_cast<float>(j);
            edgeU[u] = edgeV[v] = 1.0f;
            addParallelogram(scene, {}, corner, edgeU, edgeV);
        }
    }
    World world(std::move(scene), withAccelStructure(accel));
    for (const float zero : { 0.0f, -0.0f }) {
        for (const float side : { 1.0f, -1.0f }) {
            for (int i = 0; i <= 2 * cells; ++i) {
                for (int j = 0; j <= 2 * cells; ++j) {
                    Ray ray { glm::vec3(0.0f), glm::vec3(zero) };
                    ray.direction[axis] = side;
                    ray.origin[axis] = -2.0f * side;
                    ray.origin[u] = 0.5f * static_cast<float>(i);
                    ray.origin[v] = 0.5f * static_cast<float>(j);
                    const Answer answer = ask(world, ray);
                    CHECK(answer.isHit);
                    CHECK(answer.ray.t == 2.0f);
                }
            }
        }
    }
}

TEST_CASE("BVH, an empty scene and one of spheres alone are searched too", "[bvh]")
{
    const bool accel = GENERATE(true, false);
    World empty({}, withAccelStructure(accel));
    CHECK_FALSE(ask(empty, {}).isHit);
    Scene scene;
    scene.spheres.push_back({ .center = { 0, 0, -3 }, .radius = 1.0f });
    World spheres(std::move(scene), withAccelStructure(accel));
    CHECK(ask(spheres, {}).ray.t == Approx(2.0f));
}

TEST_CASE("BVH, a hit is described by numbers also where vertex normals cancel or are missing", "[bvh]")
{
    const bool accel = GENERATE(true, false);
    const glm::vec3 normal { 0, 0, 1 };
    for (const auto& [n0, n1] : { std::pair(normal, -normal), std::pair(glm::vec3(0.0f), glm::vec3(0.0f)) }) {
        Scene scene;
        scene.meshes.push_back(
            { { { { -1, -1, 0 }, n0, {} }, { { 1, -1, 0 }, n1, {} }, { { 0, 2, 0 }, n0, {} } }, { { 0, 1, 2 } }, {} });
        World world(std::move(scene), withAccelStructure(accel));
        world.features.enableNormalInterp = true;
        const Answer answer = ask(world, { { 0, -1, 1 }, { 0, 0, -1 } }); // halfway between the first two
        CHECK(answer.isHit);
        CHECK(isFinite(answer.hit.normal));
    }
}
