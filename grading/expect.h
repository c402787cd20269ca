#pragma once
#include "grading/exam.h"
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace grading {

[[nodiscard]] std::string toText(float value);
[[nodiscard]] std::string toText(const glm::vec2& value);
[[nodiscard]] std::string toText(const glm::vec3& value);

// Throws Wrong unless each component differs by at most the tolerance; NaN is never near.
void expectNear(const std::string& asked, float came, double expected, double tolerance);
void expectNear(const std::string& asked, const glm::vec2& came, const glm::dvec2& expected, double tolerance);
void expectNear(const std::string& asked, const glm::vec3& came, const glm::dvec3& expected, double tolerance);

// Throws Wrong, saying what came and what was expected in words.
void expect(bool holds, const std::string& asked, const std::string& came, const std::string& expected);

// Throws Wrong unless an answer has as many values as were asked for.
void expectCount(const std::string& asked, std::size_t came, std::size_t expected);

// A few roundings of numbers of about 1, as every right way to compute them leaves.
inline constexpr double fewRoundings = 1e-5;

}
