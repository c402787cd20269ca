#include "grading/checks/recursive_ways.h"
#include "grading/expect.h"
#include <cmath>
#include <fmt/format.h>

namespace grading {
namespace {

    // A new ray's start, seen from the hit point.
    struct Start {
        double distance;
        double height; // over the surface, counted towards where the ray is to start
    };

    Start startOf(const Way& way, const Incidence& incidence, const Ray& ray)
    {
        const glm::dvec3 offset = glm::dvec3(ray.origin) - incidence.point();
        return { glm::length(offset), way.side * glm::dot(offset, glm::dvec3(incidence.hitInfo.normal)) };
    }

    bool isOffSurface(const Start& start)
    {
        // Right offsets are from 1e-5 to 1e-3 of a scene whose points are up to 3.3 from the origin, and rounded by
        // 6e-7 in all: the smallest is told from 1e-6, which is too small, and remains on its side of the surface by
        // 1e-6 at least; the largest is told from 1e-2.
        constexpr double leastOffset = 5e-6;
        constexpr double mostOffset = 4e-3;
        constexpr double leastHeight = 1e-6;
        return start.distance >= leastOffset && start.distance <= mostOffset && start.height >= leastHeight;
    }

}

Incidence incidenceAt(Random& random, float minCosine, float maxCosine)
{
    Incidence incidence;
    const glm::vec3 normal = random.direction();
    const glm::vec3 tangent = glm::normalize(glm::cross(normal, random.direction()));
    const float cosine = random.uniform(minCosine, maxCosine);
    const glm::vec3 direction = std::sqrt(1.0f - cosine * cosine) * tangent - cosine * normal;
    incidence.ray = { random.vec3(-1.0f, 1.0f), glm::normalize(direction), random.uniform(0.5f, 1.5f) };
    incidence.hitInfo.normal = normal;
    incidence.hitInfo.barycentricCoord = glm::vec3(0.2f, 0.3f, 0.5f); // nothing to start a ray from
    return incidence;
}

std::vector<Incidence> incidencesAt(Random& random, float minCosine, float maxCosine)
{
    std::vector<Incidence> incidences;
    for (int i = 0; i < 400; ++i)
        incidences.push_back(incidenceAt(random, minCosine, maxCosine));
    return incidences;
}

Incidence headOn(Random& random)
{
    Incidence incidence = incidenceAt(random, cosineOfGrazing, 1.0f);
    incidence.ray.direction = -incidence.hitInfo.normal;
    return incidence;
}

std::string describe(const Incidence& incidence)
{
    return fmt::format("the ray from {} along {} that meets a surface with normal {} at t = {}",
        toText(incidence.ray.origin), toText(incidence.ray.direction), toText(incidence.hitInfo.normal),
        toText(incidence.ray.t));
}

void judgeRays(Exam& exam, const Way& way, const std::vector<Incidence>& incidences, const Judge& judge)
{
    const auto rays = exam.ask<std::vector<Ray>>(way.rayProbe, incidences);
    expectCount(way.rayFunction, rays.size(), incidences.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        judge(fmt::format("{} for {}", way.rayFunction, describe(incidences[i])), incidences[i], rays[i]);
}

void expectOffSurface(const std::string& asked, const Way& way, const Incidence& incidence, const Ray& ray)
{
    const Start start = startOf(way, incidence, ray);
    const bool isBehind = start.height * way.side < 0.0;
    expect(isOffSurface(start), "the origin of " + asked,
        fmt::format("{}, which is {:.1e} from the hit point and {:.1e} {} the surface", toText(ray.origin),
            start.distance, std::abs(start.height), isBehind ? "behind" : "in front of"),
        fmt::format("the hit point {}, moved by 1e-5 to 1e-3 to where it is {} the surface",
            toText(glm::vec3(incidence.point())), way.side < 0.0 ? "behind" : "in front of"));
}

}
