#include "grading/stress/shading_inputs.h"
#include "grading/stress/rounding.h"
#include <cfloat>

namespace stress {
namespace {

    using grading::ShadingCase;

    // Unit but for its rounding, and that in another direction each time.
    glm::vec3 nearlyUnit(Random& random, const glm::vec3& unit)
    {
        return { stepped(unit.x, random.integer(-1, 1)), stepped(unit.y, random.integer(-1, 1)),
            stepped(unit.z, random.integer(-1, 1)) };
    }

    glm::vec3 mirrored(const glm::vec3& v, const glm::vec3& n)
    {
        return 2.0f * glm::dot(n, v) * n - v;
    }

    // Not anywhere, as seen from others: nearly along them, against them, mirrored or at a right angle.
    glm::vec3 related(Random& random, const glm::vec3& to, const glm::vec3& normal)
    {
        switch (random.integer(0, 4)) {
        case 0:
            return nearlyUnit(random, to);
        case 1:
            return nearlyUnit(random, -to);
        case 2:
            return nearlyUnit(random, mirrored(to, normal));
        case 3:
            return glm::normalize(glm::cross(to, random.direction()));
        default:
            return random.direction();
        }
    }

    constexpr glm::vec3 up { 0.0f, 0.0f, 1.0f }, right_ { 1.0f, 0.0f, 0.0f };
    constexpr glm::vec3 slanted { 0.6f, 0.0f, 0.8f }, mirror { -0.6f, 0.0f, 0.8f };
    constexpr glm::vec3 longUp { 0.0f, 0.0f, 0x1.000002p0f }; // as long as rounding may leave a unit vector

    ShadingCase like(
        const glm::vec3& camera, const glm::vec3& light, float shininess, const glm::vec3& color = glm::vec3(1.0f))
    {
        return { camera, light, color, up, glm::vec3(0.5f), glm::vec3(1.0f), shininess };
    }

    ShadingCase with(ShadingCase c, const glm::vec3& normal, const glm::vec3& kd, const glm::vec3& ks)
    {
        c.normal = normal;
        c.kd = kd;
        c.ks = ks;
        return c;
    }

    double lobeDifference(const ShadingCase& c)
    {
        const glm::dvec3 n(c.normal), l(c.lightDirection), v(c.cameraDirection);
        const auto shininess = static_cast<double>(c.shininess);
        const double phong = std::max(glm::dot(2.0 * glm::dot(n, l) * n - l, v), 0.0);
        const double blinnPhong = std::max(glm::dot(n, glm::normalize(l + v)), 0.0);
        return std::pow(phong, shininess) - std::pow(blinnPhong, shininess);
    }

}

std::string describe(const ShadingCase& c)
{
    return fmt::format("camera {}, light {} of {}, normal {}, kd {}, ks {}, shininess {}", exactly(c.cameraDirection),
        exactly(c.lightDirection), exactly(c.lightColor), exactly(c.normal), exactly(c.kd), exactly(c.ks),
        exactly(c.shininess));
}

ShadingCase anyCase(Random& random)
{
    ShadingCase c {};
    c.normal = random.direction();
    c.lightDirection = related(random, c.normal, c.normal);
    c.cameraDirection = related(random, c.lightDirection, c.normal);
    c.lightColor = random.integer(0, 3) == 0 ? glm::vec3(magnitude(random, 1e-20f, 1e20f)) : random.color();
    c.kd = random.integer(0, 3) == 0 ? glm::vec3(0.0f) : random.color();
    c.ks = random.integer(0, 3) == 0 ? glm::vec3(0.0f) : random.color();
    c.shininess = random.integer(0, 9) == 0 ? 0.0f : magnitude(random, 1e-3f, 1e6f);
    return c;
}

std::vector<std::pair<std::string, ShadingCase>> specialCases()
{
    constexpr glm::vec3 black { 0.0f }, white { 1.0f };
    return {
        { "all along the normal, shininess 0", like(up, up, 0.0f) },
        { "all along the normal, shininess 1e6", like(up, up, 1e6f) },
        { "cosines above 1, shininess 1", with(like(longUp, longUp, 1.0f), longUp, white, white) },
        { "cosines above 1, shininess 1e6", with(like(longUp, longUp, 1e6f), longUp, white, white) },
        { "only the normal too long, shininess 1e6", with(like(up, up, 1e6f), longUp, white, white) },
        { "the camera in the mirrored light, shininess 1e6", like(mirror, slanted, 1e6f) },
        { "the camera in the light, shininess 1e6", like(slanted, slanted, 1e6f) },
        { "light opposite the view, from above", like(-up, up, 10.0f) },
        { "light opposite the view, from below", like(up, -up, 10.0f) },
        { "light opposite the view, slanted", like(-slanted, slanted, 10.0f) },
        { "light opposite the view, slanted, shininess 0", like(-slanted, slanted, 0.0f) },
        { "light opposite the view, slanted, shininess 1e6", like(-slanted, slanted, 1e6f) },
        { "light almost opposite the view", like({ -0.6f, 1e-7f, -0.8f }, slanted, 10.0f) },
        { "light in the surface", like(slanted, right_, 10.0f) },
        { "light and view in the surface", like(right_, right_, 10.0f) },
        { "light and view in the surface, opposite", like(-right_, right_, 10.0f) },
        { "light just behind the surface", like(slanted, { 1.0f, 0.0f, -1e-6f }, 10.0f) },
        { "light just in front of the surface", like(slanted, { 1.0f, 0.0f, 1e-6f }, 10.0f) },
        { "light behind the surface, in the camera", like(-up, -up, 1.0f) },
        { "light behind the surface, shininess 0", like(up, -up, 0.0f) },
        { "camera behind the surface", like(-slanted, up, 1.0f) },
        { "no light", like(mirror, slanted, 10.0f, black) },
        { "light of 1e38", like(up, up, 10.0f, glm::vec3(1e38f)) },
        { "light of the least float", like(up, up, 10.0f, glm::vec3(FLT_TRUE_MIN)) },
        { "light in one channel", like(up, up, 10.0f, { 0.0f, 1.0f, 0.0f }) },
        { "kd 0", with(like(mirror, slanted, 10.0f), up, black, white) },
        { "ks 0", with(like(mirror, slanted, 10.0f), up, white, black) },
        { "kd and ks 0, light of 1e38", with(like(up, up, 10.0f, glm::vec3(1e38f)), up, black, black) },
        { "the least shininess", like(mirror, up, FLT_TRUE_MIN) },
    };
}

// Drawn until there is one: Phong's is brighter where both directions are steep to the surface's other side.
ShadingCase decidedCase(Random& random, bool phongIsBrighter)
{
    for (;;) {
        ShadingCase c { random.direction(), random.direction(), glm::vec3(1.0f), random.direction() };
        c.shininess = random.uniform(1.0f, 4.0f);
        const double difference = lobeDifference(c) * (phongIsBrighter ? 1.0 : -1.0);
        const bool isSeen
            = glm::dot(c.normal, c.cameraDirection) > 0.02f && glm::dot(c.normal, c.lightDirection) > 0.02f;
        if (isSeen && difference > 0.02)
            return c;
    }
}

}
