#include "grading/checks/bvh_rays.h"
#include "grading/expect.h"
#include "worker/scene_message.h"
#include <fmt/format.h>

namespace grading {
namespace {

    std::string hitAt(bool isHit, double t)
    {
        return isHit ? fmt::format("a hit at t = {:.6g}", t) : "no hit";
    }

    float randomSign(Random& random)
    {
        return random.integer(0, 1) == 0 ? -1.0f : 1.0f;
    }

}

Ray rayFromOutside(Random& random)
{
    const glm::vec3 origin = 4.0f * random.direction();
    return { origin, glm::normalize(random.vec3(-1.0f, 1.0f) - origin) };
}

Ray rayFromInside(Random& random)
{
    const glm::vec3 origin = random.vec3(-1.0f, 1.0f);
    return { origin, random.direction() };
}

Ray rayAlongAxis(Random& random)
{
    Ray ray { random.vec3(-1.0f, 1.0f), {} };
    for (int axis = 0; axis < 3; ++axis)
        ray.direction[axis] = 0.0f * randomSign(random);
    const int axis = random.integer(0, 2);
    ray.direction[axis] = randomSign(random);
    ray.origin[axis] = -4.0f * ray.direction[axis];
    return ray;
}

Ray rayOfAnyLength(Random& random)
{
    Ray ray = rayFromOutside(random);
    ray.direction *= std::pow(10.0f, random.uniform(-1.5f, 1.5f));
    return ray;
}

std::vector<Ray> clearRays(Random& random, const Scene& scene, int count, MakeRay make)
{
    std::vector<Ray> rays;
    while (static_cast<int>(rays.size()) < count) {
        const Ray ray = make(random);
        if (closestHit(scene, ray).isClear)
            rays.push_back(ray);
    }
    return rays;
}

std::string TracedRay::asked(const std::string& value) const
{
    std::size_t numTriangles = 0;
    for (const Mesh& mesh : scene.meshes)
        numTriangles += mesh.triangles.size();
    const std::string limit = ray.t == FLT_MAX ? "" : fmt::format(" with ray.t = {}", toText(ray.t));
    return fmt::format("{}BVH::intersect from {} along {}{} among {} triangles and {} spheres", value,
        toText(ray.origin), toText(ray.direction), limit, numTriangles, scene.spheres.size());
}

bool isClosest(const TracedRay& traced)
{
    const auto& [scene, ray, came, expected] = traced;
    const double difference
        = (static_cast<double>(came.t) - expected.t) * static_cast<double>(glm::length(ray.direction));
    return came.isHit == expected.isHit && (!came.isHit || std::abs(difference) <= distanceTolerance);
}

void expectClosest(const TracedRay& traced)
{
    const auto& [scene, ray, came, expected] = traced;
    expect(isClosest(traced), traced.asked(), hitAt(came.isHit, static_cast<double>(came.t)),
        hitAt(expected.isHit, expected.t));
}

void expectMaterial(const TracedRay& traced)
{
    const Material& came = traced.came.hitInfo.material;
    const Material& expected = *traced.expected.material;
    const bool isSame = came.kd == expected.kd && came.ks == expected.ks && came.shininess == expected.shininess;
    expect(isSame, traced.asked("hitInfo.material after "), "kd = " + toText(came.kd), "kd = " + toText(expected.kd));
}

std::vector<Traversal> traverse(Exam& exam, const Scene& scene, const Features& features, const std::vector<Ray>& rays,
    const AxisAlignedBox& hidden)
{
    auto traversals = exam.ask<std::vector<Traversal>>("bvh.intersect", scene, features, hidden, rays);
    expectCount("BVH::intersect", traversals.size(), rays.size());
    return traversals;
}

void compare(Exam& exam, const Scene& scene, const Features& features, const std::vector<Ray>& rays, Judge judge)
{
    const std::vector<Traversal> came = traverse(exam, scene, features, rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
        judge({ scene, rays[i], came[i], closestHit(scene, rays[i]) });
}

void compareAmongTriangles(Exam& exam, MakeRay make)
{
    Scene scene;
    addTriangles(scene, exam.random, 200);
    compare(exam, scene, withTree, clearRays(exam.random, scene, 400, make), expectClosest);
}

void compareHitInfo(Exam& exam, const Features& features, Judge judge, MakeRay make)
{
    Scene scene;
    addTriangles(scene, exam.random, 200);
    const std::vector<Ray> rays = clearRays(exam.random, scene, 400, make);
    const std::vector<Traversal> came = traverse(exam, scene, features, rays);
    std::size_t numHits = 0, numJudged = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const SceneHit expected = closestHit(scene, rays[i]);
        const TracedRay traced { scene, rays[i], came[i], expected };
        numHits += expected.isHit;
        if (!expected.isHit || !isClosest(traced))
            continue;
        ++numJudged;
        judge(traced);
    }
    expect(4 * numJudged >= numHits, fmt::format("BVH::intersect for rays that have {} hits", numHits),
        fmt::format("the right one for {}", numJudged), "more, to judge what it says of them");
}

}
