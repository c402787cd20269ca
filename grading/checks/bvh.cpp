#include "grading/check.h"
#include "grading/checks/bvh_rays.h"
#include "grading/expect.h"

namespace grading::bvh {
namespace {

    const Check triangles("bvh.closest.outside", 2.0,
        "both children may hold the closest hit: keep going until no box is left, and put ray.t back after a box test",
        [](Exam& exam) { compareAmongTriangles(exam, rayFromOutside); });
    // Towards some triangle of the only mesh.
    Ray rayAtTriangle(Random& random, const Scene& scene)
    {
        const Mesh& mesh = scene.meshes[0];
        const int last = static_cast<int>(mesh.triangles.size()) - 1;
        const glm::uvec3 triangle = mesh.triangles[static_cast<std::size_t>(random.integer(0, last))];
        glm::vec3 middle { 0.0f };
        for (int corner = 0; corner < 3; ++corner)
            middle += mesh.vertices[triangle[corner]].position / 3.0f;
        const glm::vec3 origin = 4.0f * random.direction();
        return { origin, glm::normalize(middle - origin) };
    }

    const Check few("bvh.closest.few", 0.5,
        "a scene of up to LeafSize triangles has a tree whose root is a leaf: look at a node before going to its "
        "children",
        [](Exam& exam) {
            for (int count = 1; count <= 6; ++count) {
                Scene scene;
                addTriangles(scene, exam.random, count);
                std::vector<Ray> rays;
                for (int i = 0; i < 30; ++i)
                    if (const Ray ray = rayAtTriangle(exam.random, scene); closestHit(scene, ray).isClear)
                        rays.push_back(ray);
                compare(exam, scene, withTree, rays, expectClosest);
            }
        });

    const Check inside("bvh.closest.inside", 2.0,
        "a ray may start inside a box: then it enters before 0, and only a box that it leaves before 0 is missed",
        [](Exam& exam) { compareAmongTriangles(exam, rayFromInside); });
    const Check axes("bvh.closest.axes", 1.5,
        "a direction of 0 along an axis makes the slab's distances infinite; numeric_limits::min() is no minus "
        "infinity",
        [](Exam& exam) { compareAmongTriangles(exam, rayAlongAxis); });
    const Check lengths("bvh.closest.lengths", 0.5,
        "ray.t counts in units of the direction, which need not be of length 1: do not normalise it, nor compare t to "
        "lengths",
        [](Exam& exam) { compareAmongTriangles(exam, rayOfAnyLength); });

    // (u, v, w) as coordinates along three axes, w along the axis of this number.
    glm::vec3 turned(const glm::vec3& uvw, int axis)
    {
        glm::vec3 result;
        for (int i = 0; i < 3; ++i)
            result[(axis + 1 + i) % 3] = uvw[i];
        return result;
    }

    // Rectangles with integer corners, in planes across the axis.
    Scene rectangles(Random& random, int axis)
    {
        Scene scene;
        for (int i = 0; i < 40; ++i) {
            Mesh& mesh = scene.meshes.emplace_back();
            const glm::vec2 lower { random.integer(0, 20), random.integer(0, 20) };
            const glm::vec2 upper = lower + glm::vec2 { random.integer(1, 4), random.integer(1, 4) };
            const auto height = static_cast<float>(random.integer(0, 9));
            for (const glm::vec2 uv : { lower, glm::vec2(upper.x, lower.y), upper, glm::vec2(lower.x, upper.y) })
                mesh.vertices.push_back({ turned({ uv, height }, axis), turned({ 0, 0, 1 }, axis), uv });
            mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
        }
        return scene;
    }

    // Along the axis through a point on the outline of a rectangle, so along a face of its box. All numbers are short
    // in binary: no rounding decides whether the edge, which belongs to the rectangle, is met.
    Ray rayThroughOutline(Random& random, const Mesh& rectangle, int axis)
    {
        const int edge = random.integer(0, 3);
        const glm::vec3 a = rectangle.vertices[static_cast<std::size_t>(edge)].position;
        const glm::vec3 b = rectangle.vertices[static_cast<std::size_t>((edge + 1) % 4)].position;
        const bool forwards = random.integer(0, 1) == 0;
        Ray ray { glm::mix(a, b, 0.125f), turned({ 0.0f, -0.0f, forwards ? 1.0f : -1.0f }, axis) };
        ray.origin[axis] = forwards ? -4.0f : 16.0f;
        return ray;
    }

    const Check faces("bvh.closest.faces", 0.5,
        "a ray along a face of a box gives 0 * infinity, which is NaN: the face belongs to the box, and a box may be "
        "flat",
        [](Exam& exam) {
            for (int axis = 0; axis < 3; ++axis) {
                const Scene scene = rectangles(exam.random, axis);
                std::vector<Ray> rays;
                for (const Mesh& rectangle : scene.meshes)
                    for (int i = 0; i < 8; ++i)
                        rays.push_back(rayThroughOutline(exam.random, rectangle, axis));
                compare(exam, scene, withTree, rays, expectClosest);
            }
        });

    // Each ray twice: it ends just behind what it would hit, and just before.
    std::vector<Ray> limitedRays(Random& random, const Scene& scene)
    {
        std::vector<Ray> rays;
        for (Ray ray : clearRays(random, scene, 300, rayFromOutside)) {
            const SceneHit hit = closestHit(scene, ray);
            for (const double factor : { 0.998, 1.002 }) {
                ray.t = static_cast<float>(hit.t * factor);
                if (hit.isHit && closestHit(scene, ray).isClear)
                    rays.push_back(ray);
            }
        }
        return rays;
    }

    const Check limited("bvh.closest.limited", 1.5,
        "ray.t is how far the ray reaches when it comes in: what lies beyond is no hit, for boxes and triangles alike",
        [](Exam& exam) {
            Scene scene;
            addTriangles(scene, exam.random, 200);
            compare(exam, scene, withTree, limitedRays(exam.random, scene), expectClosest);
        });

    void expectUntouchedByMiss(const TracedRay& traced)
    {
        expectClosest(traced);
        if (!traced.expected.isHit)
            expect(traced.came.t == traced.ray.t, traced.asked("ray.t after "), toText(traced.came.t),
                toText(traced.ray.t) + " as before: there is nothing to hit");
    }

    const Check misses("bvh.closest.misses", 1.0,
        "a box test that shortens the ray must be undone: a ray that meets nothing keeps its t, and the answer is "
        "false",
        [](Exam& exam) {
            Scene scene;
            addTriangles(scene, exam.random, 20);
            std::vector<Ray> rays = clearRays(exam.random, scene, 400, rayFromOutside);
            for (std::size_t i = 0; i < rays.size(); i += 2)
                rays[i].t = exam.random.uniform(8.0f, 100.0f); // behind all
            compare(exam, scene, withTree, rays, expectUntouchedByMiss);
        });

    // Triangles that are points, segments, and others of the same place.
    void addDegenerate(Scene& scene, Random& random)
    {
        Mesh& mesh = scene.meshes.emplace_back();
        for (int i = 0; i < 60; ++i) {
            auto corners = randomTriangle(random, glm::vec3(0.0f));
            for (Vertex& corner : corners) // exact halves below
                corner.position = glm::round(corner.position * 64.0f) / 64.0f;
            corners[2] = corners[0];
            if (i % 3 == 0)
                corners[1] = corners[0];
            else if (i % 3 == 1)
                corners[2].position = 0.5f * (corners[0].position + corners[1].position);
            addTriangle(mesh, corners);
        }
        const Mesh copy = scene.meshes.front();
        for (int i = 0; i < 5; ++i) // more of them in one place than fit into a leaf
            scene.meshes.push_back(copy);
    }

    const Check degenerate("bvh.closest.degenerate", 0.5,
        "triangles without area are never met, and equal ones may fill several leaves: no NaN may end up in ray.t",
        [](Exam& exam) {
            Scene scene;
            addTriangles(scene, exam.random, 100);
            const std::vector<Ray> rays = clearRays(exam.random, scene, 300, rayFromOutside);
            addDegenerate(scene, exam.random);
            compare(exam, scene, withTree, rays, expectClosest);
        });

    void expectClosestOfBothKinds(const TracedRay& traced)
    {
        expectClosest(traced);
        if (traced.expected.isHit && !traced.expected.mesh)
            expectMaterial(traced);
    }

    const Check spheres("bvh.spheres.among_triangles", 1.5,
        "the tree holds triangles alone: all spheres are tried as well, and the nearest hit of either kind counts",
        [](Exam& exam) {
            Scene scene;
            addTriangles(scene, exam.random, 60);
            addSpheres(scene, exam.random, 8);
            compare(
                exam, scene, withTree, clearRays(exam.random, scene, 500, rayFromOutside), expectClosestOfBothKinds);
        });

    const Check onlySpheres("bvh.spheres.alone", 0.5,
        "a scene without triangles has a tree with an empty leaf for a root; its spheres are met within ray.t, from "
        "inside as well",
        [](Exam& exam) {
            Scene scene;
            compare(exam, scene, withTree, { rayFromOutside(exam.random) }, expectClosest);
            addSpheres(scene, exam.random, 12);
            compare(
                exam, scene, withTree, clearRays(exam.random, scene, 200, rayFromOutside), expectClosestOfBothKinds);
            compare(exam, scene, withTree, clearRays(exam.random, scene, 200, rayFromInside), expectClosestOfBothKinds);
            compare(exam, scene, withTree, limitedRays(exam.random, scene), expectClosestOfBothKinds);
        });

}
}
