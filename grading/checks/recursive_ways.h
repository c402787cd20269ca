#pragma once
#include "grading/exam.h"
#include "grading/oracle/recursion.h"
#include <functional>
#include <string>
#include <vector>

// What the checks of reflection and of transparency have in common.
namespace grading {

// One of the two ways of light that are graded.
struct Way {
    std::string rayProbe, rayFunction;
    std::string componentProbe, componentFunction;
    glm::dvec3 (*direction)(const Incidence&); // oracle, unit
    double side; // where the new ray starts: +1 where the normal points, -1 behind the surface
    Combine combine; // oracle
};

inline const Way reflection { "recursive.reflectionRay", "generateReflectionRay", "recursive.specular",
    "renderRaySpecularComponent", mirrored, 1.0, addMirrored };
inline const Way passthrough { "recursive.passthroughRay", "generatePassthroughRay", "recursive.transparent",
    "renderRayTransparentComponent", straightOn, -1.0, blendWithBehind };

inline constexpr float cosineOfGrazing = 0.2f; // offsets along a ray that grazes the surface hardly leave it

// A ray that meets a surface at a point within 3.3 of the origin, at an angle to the normal with a cosine between
// the two.
[[nodiscard]] Incidence incidenceAt(Random& random, float minCosine, float maxCosine);
[[nodiscard]] std::vector<Incidence> incidencesAt(Random& random, float minCosine, float maxCosine);
[[nodiscard]] Incidence headOn(Random& random);

[[nodiscard]] std::string describe(const Incidence& incidence);

// Calls judge(what was asked, incidence, ray) for each ray that the submission makes.
using Judge = std::function<void(const std::string& asked, const Incidence&, const Ray&)>;
void judgeRays(Exam& exam, const Way& way, const std::vector<Incidence>& incidences, const Judge& judge);

// Throws Wrong unless the ray starts near its surface and on the right side of it.
void expectOffSurface(const std::string& asked, const Way& way, const Incidence& incidence, const Ray& ray);

}
