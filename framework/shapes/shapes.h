#pragma once
#include <framework/mesh.h>
#include <optional>
#include <string_view>
#include <vector>

namespace shapes {

// A built-in shape by its name, empty for an unknown one. Triangles are counter-clockwise seen from outside,
// normals point outwards, texture coordinates lie in [0, 1], the material is the default. The side that shows
// first, such as a face, looks along -z, where the default camera stands; up is +y.
[[nodiscard]] std::optional<Mesh> makeShape(std::string_view name);

// In the order from simple to large.
[[nodiscard]] std::vector<std::string_view> shapeNames();

}
