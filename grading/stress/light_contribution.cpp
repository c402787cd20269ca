#include "grading/stress/probes/lights.h"
#include "grading/stress/rounding.h"
#include "grading/stress/stress.h"
#include <array>

// What unoccluded lights contribute, near and far, small and large.
namespace stress::light_contribution {
namespace {

    using grading::Incidence;
    using Kind = Shining::Kind;

    std::string describe(const Shining& query)
    {
        const auto& [ray, hit] = query.shaded;
        const ParallelogramLight& light = query.light;
        return fmt::format("a light at {}, edges {} and {}, first colour {}, of {} samples, on {} + {} * {}, normal {}",
            exactly(light.v0), exactly(light.edge01), exactly(light.edge02), exactly(light.color0), query.numSamples,
            exactly(ray.origin), exactly(ray.t), exactly(ray.direction), exactly(hit.normal));
    }

    std::array<glm::dvec3, 4> cornersOf(const Shining& query)
    {
        const glm::dvec3 v0(query.light.v0), edge01(query.light.edge01), edge02(query.light.edge02);
        const glm::dvec3 along = query.kind == Kind::Point ? glm::dvec3(0.0) : edge01;
        const glm::dvec3 across = query.kind == Kind::Parallelogram ? edge02 : glm::dvec3(0.0);
        return { v0, v0 + along, v0 + across, v0 + along + across };
    }

    // Of the cosine: the shaded point and the light's are rounded, and what that means follows from their distance.
    double roundedCosine(const Shining& query, const glm::dvec3& light)
    {
        const auto& [ray, hit] = query.shaded;
        const double size = glm::length(glm::dvec3(ray.origin)) + static_cast<double>(ray.t) + glm::length(light);
        return ulpOfOne * (4.0 + 4.0 * size / glm::distance(light, query.shaded.point()));
    }

    struct Cosines {
        double least = 1.0, most = -1.0;
    };

    // Those of all places on the light are between those of its corners, or unknown if they differ: it may come close.
    Cosines cosinesOf(const Shining& query)
    {
        Cosines cosines;
        bool isSmall = true;
        const auto corners = cornersOf(query);
        for (const glm::dvec3& corner : corners) {
            const glm::dvec3 toLight = corner - query.shaded.point();
            const double distance = glm::length(toLight);
            if (distance == 0.0)
                return { -1.0, 1.0 };
            const double cosine = glm::dot(toLight / distance, glm::dvec3(query.shaded.hitInfo.normal));
            const double rounded = roundedCosine(query, corner);
            cosines.least = std::min(cosines.least, cosine - rounded);
            cosines.most = std::max(cosines.most, cosine + rounded);
            isSmall &= corner == corners[0];
        }
        return isSmall || cosines.most < 0.0 ? cosines : Cosines { -1.0, 1.0 };
    }

    Judgement judge(const Shining& query, const glm::vec3& came)
    {
        const auto& [v0, edge01, edge02, color0, color1, color2, color3] = query.light;
        const Material& material = query.shaded.hitInfo.material;
        const auto [least, most] = cosinesOf(query);
        const bool isPoint = query.kind == Kind::Point;
        const glm::dvec3 others = isPoint ? color0 : glm::max(color1, glm::max(color2, color3));
        const glm::dvec3 brightest = glm::max(glm::dvec3(color0), others);
        const glm::dvec3 darkest = isPoint || (color0 == color1 && color0 == color2 && color0 == color3)
            ? glm::dvec3(color0)
            : glm::dvec3(0.0);
        const glm::dvec3 highlight
            = query.model == ShadingModel::Lambertian || most < 0.0 ? glm::vec3(0.0f) : material.ks;
        const double added = ulpOfOne * (16.0 + query.numSamples); // the mean is a sum of so many
        return judgeInside(came, darkest * glm::dvec3(material.kd) * std::max(least, 0.0) * (1.0 - added),
            brightest * (glm::dvec3(material.kd) * std::clamp(most, 0.0, 1.0) + highlight) * (1.0 + added));
    }

    const Question<Shining, glm::vec3> contribution { "stress.contribution", describe, judge };

    Shining above(const glm::vec3& point, const glm::vec3& normal, const glm::vec3& from, float t)
    {
        Shining query {};
        query.shaded.ray = { point + t * from, -from, t };
        query.shaded.hitInfo.normal = normal;
        query.shaded.hitInfo.material = { .kd = { 0.6f, 0.3f, 0.8f }, .ks = glm::vec3(0.5f), .shininess = 10.0f };
        query.numSamples = 1;
        return query;
    }

    ShadingModel anyModel(Random& random)
    {
        return static_cast<ShadingModel>(random.integer(0, 2));
    }

    Shining anyLight(Random& random)
    {
        const float size = magnitude(random, 1e-4f, 1e4f);
        const glm::vec3 normal = random.direction();
        glm::vec3 from = random.direction();
        from = glm::dot(from, normal) < 0.0f ? -from : from;
        Shining query = above(random.vec3(-size, size), normal, from, magnitude(random, 1e-4f, 1e4f));
        query.kind = static_cast<Kind>(random.integer(0, 2));
        query.model = anyModel(random);
        query.numSamples = query.kind == Kind::Point ? 1u : static_cast<uint32_t>(random.integer(1, 8));
        const glm::vec3 point { query.shaded.point() };
        query.light.v0 = point + magnitude(random, 1e-8f, 1e6f) * random.direction();
        if (random.integer(0, 1) == 0) {
            query.light.edge01 = magnitude(random, 1e-6f, 1e3f) * random.direction();
            query.light.edge02 = random.integer(0, 1) == 0 ? 2.0f * query.light.edge01 : random.vec3(-size, size);
        }
        const glm::vec3 color = magnitude(random, 1e-6f, 1e6f) * random.color();
        query.light.color0 = query.light.color1 = query.light.color2 = query.light.color3 = color;
        return query;
    }

    const Stress anywhere("light.contribution.anywhere", contribution, randomly<Shining>(400'000, anyLight));

    constexpr glm::vec3 up { 0.0f, 0.0f, 1.0f }, x { 1.0f, 0.0f, 0.0f }, slanted { 0.6f, 0.0f, 0.8f };

    // A light of two edges over, or under, the point (0, 0, 0) of the plane z = 0.
    Shining over(const glm::vec3& v0, const glm::vec3& edge01, const glm::vec3& edge02, uint32_t numSamples = 16,
        const glm::vec3& color = glm::vec3(1.0f))
    {
        Shining query = above(glm::vec3(0.0f), up, slanted, 2.0f);
        query.kind = Kind::Parallelogram;
        query.model = ShadingModel::Phong;
        query.light = { v0, edge01, edge02, color, color, color, color };
        query.numSamples = numSamples;
        return query;
    }

    Shining as(Shining query, Kind kind, ShadingModel model)
    {
        query.kind = kind;
        query.model = model;
        return query;
    }

    constexpr glm::vec3 none { 0.0f };
    constexpr auto lambertian = ShadingModel::Lambertian;
    constexpr auto blinnPhong = ShadingModel::BlinnPhong;

    const Stress special("light.contribution.special", contribution,
        constructed<Shining>({
            { "a point light at the point, Lambert", as(over(none, none, none), Kind::Point, lambertian) },
            { "a point light at the point, Phong", as(over(none, none, none), Kind::Point, ShadingModel::Phong) },
            { "a point light at the point, Blinn-Phong", as(over(none, none, none), Kind::Point, blinnPhong) },
            { "a segment without length at the point", as(over(none, none, none), Kind::Segment, lambertian) },
            { "a parallelogram without edges at the point", over(none, none, none) },
            { "a point light 1e-25 above the point", as(over(1e-25f * up, none, none), Kind::Point, lambertian) },
            { "a point light 1e-7 above the point", as(over(1e-7f * up, none, none), Kind::Point, lambertian) },
            { "a point light in the surface", as(over(x, none, none), Kind::Point, lambertian) },
            { "a point light just behind the surface", as(over(x - 1e-3f * up, none, none), Kind::Point, blinnPhong) },
            { "a point light behind the surface", as(over(-up, none, none), Kind::Point, ShadingModel::Phong) },
            { "a point light 1e18 away", as(over(1e18f * up, none, none), Kind::Point, lambertian) },
            { "a point light at the camera", as(over(2.0f * slanted, none, none), Kind::Point, blinnPhong) },
            { "a segment through the point", as(over(-up, 2.0f * up, none), Kind::Segment, ShadingModel::Phong) },
            { "a segment in the surface", as(over(-x, 2.0f * x, none), Kind::Segment, blinnPhong) },
            { "a segment behind the surface", as(over(-up, x, none), Kind::Segment, blinnPhong) },
            { "a segment that touches the surface", as(over(x, up, none), Kind::Segment, lambertian) },
            { "a segment without length", as(over(up, none, none, 4096), Kind::Segment, lambertian) },
            { "a parallelogram with collinear edges", over(up, x, 2.0f * x) },
            { "a parallelogram with opposite edges", over(up, x, -x) },
            { "a parallelogram around the point", over({ -1.0f, -1.0f, 0.0f }, 2.0f * x, { 0.0f, 2.0f, 0.0f }) },
            { "a parallelogram on the surface", over({ -1.0f, -1.0f, 1e-6f }, 2.0f * x, { 0.0f, 2.0f, 0.0f }) },
            { "a parallelogram behind the surface", over({ -1.0f, -1.0f, -1.0f }, 2.0f * x, { 0.0f, 2.0f, 0.0f }) },
            { "one sample", over(up, x, { 0.0f, 1.0f, 0.0f }, 1) },
            { "4,096 samples", over(up, x, { 0.0f, 1.0f, 0.0f }, 4096) },
            { "4,096 samples of one place", over(up, none, none, 4096) },
            { "light of 1e30", over(up, x, { 0.0f, 1.0f, 0.0f }, 16, glm::vec3(1e30f)) },
            { "no light", over(up, x, { 0.0f, 1.0f, 0.0f }, 16, none) },
        }));

}
}
