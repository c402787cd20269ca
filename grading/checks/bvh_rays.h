#pragma once
#include "accel/bounds.h"
#include "grading/exam.h"
#include "grading/oracle/brute_force.h"
#include "grading/oracle/random_scene.h"
#include "grading/probes/traversal.h"
#include <string>
#include <vector>

// Rays for the checks of the tree's traversal.
namespace grading {

inline const Features withTree { .enableAccelStructure = true };

// Float distances in scenes of a size of about 1, seen from up to 5 away, are off by 1e-6; the next hit is 1e-3 away.
inline constexpr double distanceTolerance = 1e-4;

using MakeRay = Ray (*)(Random&);

[[nodiscard]] Ray rayFromOutside(Random& random); // of the box of +-1, into it
[[nodiscard]] Ray rayFromInside(Random& random);
[[nodiscard]] Ray rayAlongAxis(Random& random); // from outside, with zeros of either sign
[[nodiscard]] Ray rayOfAnyLength(Random& random); // from outside, the direction 0.03 to 30 long

// Rays whose answer no rounding decides.
[[nodiscard]] std::vector<Ray> clearRays(Random& random, const Scene& scene, int count, MakeRay make);

// What became of a ray, and what should have.
struct TracedRay {
    const Scene& scene;
    const Ray& ray; // as sent
    const Traversal& came;
    const SceneHit& expected;

    [[nodiscard]] std::string asked(const std::string& value = "") const;
};
using Judge = void (*)(const TracedRay&);

[[nodiscard]] bool isClosest(const TracedRay& traced); // by the distance alone: each part of hitInfo has its own check
void expectClosest(const TracedRay& traced);
void expectMaterial(const TracedRay& traced);

// Sends rays into the submission's traversal; what happens to boxes in the hidden region, the probe says.
[[nodiscard]] std::vector<Traversal> traverse(Exam& exam, const Scene& scene, const Features& features,
    const std::vector<Ray>& rays, const AxisAlignedBox& hidden = accel::emptyBox());

void compare(Exam& exam, const Scene& scene, const Features& features, const std::vector<Ray>& rays, Judge judge);

// The same in the usual scene.
void compareAmongTriangles(Exam& exam, MakeRay make);

// Judges what is said of hits, where the hit itself is right: what is not has cost points already.
void compareHitInfo(Exam& exam, const Features& features, Judge judge, MakeRay make = rayFromOutside);

}
