#include "grading/expect.h"
#include <cmath>
#include <fmt/format.h>

namespace grading {
namespace {

    bool isNear(double came, double expected, double tolerance)
    {
        return std::abs(came - expected) <= tolerance; // false for NaN
    }

    template <typename V, typename D>
    void expectVectorNear(const std::string& asked, const V& came, const D& expected, double tolerance)
    {
        for (int i = 0; i < V::length(); ++i)
            if (!isNear(static_cast<double>(came[i]), expected[i], tolerance))
                throw Wrong(asked, toText(came), toText(V(expected)));
    }

}

std::string toText(float value)
{
    return fmt::format("{:.6g}", value);
}

std::string toText(const glm::vec2& value)
{
    return fmt::format("({:.6g}, {:.6g})", value.x, value.y);
}

std::string toText(const glm::vec3& value)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", value.x, value.y, value.z);
}

void expectNear(const std::string& asked, float came, double expected, double tolerance)
{
    if (!isNear(static_cast<double>(came), expected, tolerance))
        throw Wrong(asked, toText(came), toText(static_cast<float>(expected)));
}

void expectNear(const std::string& asked, const glm::vec2& came, const glm::dvec2& expected, double tolerance)
{
    expectVectorNear(asked, came, expected, tolerance);
}

void expectNear(const std::string& asked, const glm::vec3& came, const glm::dvec3& expected, double tolerance)
{
    expectVectorNear(asked, came, expected, tolerance);
}

void expect(bool holds, const std::string& asked, const std::string& came, const std::string& expected)
{
    if (!holds)
        throw Wrong(asked, came, expected);
}

void expectCount(const std::string& asked, std::size_t came, std::size_t expected)
{
    if (came != expected)
        throw Wrong(asked, fmt::format("{} values", came), fmt::format("{}", expected));
}

}
