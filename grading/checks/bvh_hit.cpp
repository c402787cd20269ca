#include "grading/check.h"
#include "grading/checks/bvh_rays.h"
#include "grading/expect.h"

// What the traversal says of the closest hit.
namespace grading::bvh_hit {
namespace {

    // The point is off by 1e-6, seen from a triangle that is a tenth high and met at 3 degrees or more.
    constexpr double barycentricTolerance = 1e-3;

    void expectBarycentric(const TracedRay& traced)
    {
        expectNear(traced.asked("hitInfo.barycentricCoord after "), traced.came.hitInfo.barycentricCoord,
            traced.expected.barycentric, barycentricTolerance);
    }

    const Vertex& vertexOf(const SceneHit& hit, int corner)
    {
        return hit.mesh->vertices[hit.triangle[corner]];
    }

    void expectTexCoord(const TracedRay& traced)
    {
        glm::dvec2 texCoord { 0.0 };
        for (int i = 0; i < 3; ++i)
            texCoord += traced.expected.barycentric[i] * glm::dvec2(vertexOf(traced.expected, i).texCoord);
        expectNear(
            traced.asked("hitInfo.texCoord after "), traced.came.hitInfo.texCoord, texCoord, barycentricTolerance);
    }

    void expectFlatNormal(const TracedRay& traced)
    {
        expectNear(traced.asked("hitInfo.normal after "), traced.came.hitInfo.normal, traced.expected.normal,
            distanceTolerance);
    }

    // It faces the ray. Turned by the flat normal it may also face away, where that and the interpolated one are on
    // different sides of a ray that grazes the triangle: either way to turn it is right.
    bool isOnSideOfRay(const TracedRay& traced)
    {
        const glm::dvec3 normal { traced.came.hitInfo.normal };
        const glm::dvec3 direction = glm::normalize(glm::dvec3(traced.ray.direction));
        return glm::dot(normal, direction) <= fewRoundings || glm::dot(normal, traced.expected.normal) > 0.0;
    }

    void expectSmoothNormal(const TracedRay& traced)
    {
        glm::dvec3 normal { 0.0 };
        for (int i = 0; i < 3; ++i)
            normal += traced.expected.barycentric[i] * glm::dvec3(vertexOf(traced.expected, i).normal);
        const glm::vec3 came = traced.came.hitInfo.normal;
        normal *= glm::dot(normal, glm::dvec3(came)) < 0.0 ? -1.0 : 1.0;
        const std::string asked = traced.asked("hitInfo.normal, interpolated, after ");
        expectNear(asked, came, glm::normalize(normal), barycentricTolerance);
        expect(isOnSideOfRay(traced), asked, toText(came), toText(-came) + ", which faces the ray");
    }

    const Check material("bvh.hit.material", 1.0,
        "hitInfo describes the closest hit, not the triangle that was tested or hit last",
        [](Exam& exam) { compareHitInfo(exam, withTree, expectMaterial); });
    const Check barycentric("bvh.hit.barycentric", 1.0,
        "computeBarycentricCoord gets the corners of the closest triangle in their order, and the point at the final "
        "ray.t, ray.origin + ray.t * ray.direction, whatever the direction's length",
        [](Exam& exam) {
            compareHitInfo(exam, withTree, expectBarycentric);
            compareHitInfo(exam, withTree, expectBarycentric, rayOfAnyLength);
        });

    const Check texCoord(
        "bvh.hit.texcoord", 1.0, "texture coordinates are interpolated whether or not normals are", [](Exam& exam) {
            Features features = withTree;
            features.enableTextureMapping = true;
            compareHitInfo(exam, features, expectTexCoord);
            features.enableNormalInterp = true;
            compareHitInfo(exam, features, expectTexCoord);
        });

    const Check flatNormal("bvh.hit.normal", 1.0,
        "the normal is that of the closest triangle, of length 1, and turned towards the ray, shadows or not",
        [](Exam& exam) {
            Features features = withTree;
            compareHitInfo(exam, features, expectFlatNormal);
            features.enableShadows = true;
            compareHitInfo(exam, features, expectFlatNormal);
        });

    const Check smoothNormal("bvh.hit.smooth_normal", 0.5,
        "with enableNormalInterp the vertex normals are interpolated, by the same barycentric coordinates, and the "
        "result is turned towards the ray",
        [](Exam& exam) {
            Features features = withTree;
            features.enableNormalInterp = true;
            compareHitInfo(exam, features, expectSmoothNormal);
        });

}
}
