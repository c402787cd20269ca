#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

namespace debug {

// What is measured of each pixel of a picture. A number is kept in x alone.
enum class Quantity : uint8_t {
    Color, // as the pixel is traced
    Normal, // of what the ray through the pixel's middle meets, like the next two
    TexCoord,
    Barycentric,
    NodesVisited, // by that ray: boxes of the tree that it enters
    TrianglesTested, // against that ray
    Samples, // rays through the pixel
    Rays, // those, and all that follow from them
    Distance, // t of the ray through the middle
};

// The value where a ray meets nothing. Not NaN: a submission that computes that has made a mistake, which shows.
inline constexpr glm::vec3 nothing { std::numeric_limits<float>::infinity() };

[[nodiscard]] std::vector<Quantity> allQuantities(); // in the order in which they are stepped through
[[nodiscard]] Quantity nextOf(Quantity quantity); // the first after the last
[[nodiscard]] std::string nameOf(Quantity quantity); // such as "tex_coord"
[[nodiscard]] std::string quantityNames(); // of all, for people
[[nodiscard]] Quantity quantityOf(const std::string& name); // throws std::invalid_argument
[[nodiscard]] bool isNumber(Quantity quantity); // and not a vector

// For people: the name and the value, such as "normal (0, 1, 0)" or "t 3.21".
[[nodiscard]] std::string describe(Quantity quantity, const glm::vec3& value);

}
