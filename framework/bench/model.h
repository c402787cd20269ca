#pragma once
#include "common.h"
#include <array>
#include <filesystem>
#include <framework/trackball.h>
#include <string>
#include <string_view>

namespace bench {

using Triangle = std::array<glm::vec3, 3>;

// What is traced: triangles, from where they are looked at, from where they are lit.
struct Model {
    std::string name;
    std::vector<Triangle> triangles;
    std::vector<Trackball> cameras;
    std::vector<glm::vec3> lights;
};

// An OBJ file in the unit ball. It is seen from outside, or from its middle if more front sides show there, as in a
// building; the lights stand on the camera's side of it. Throws files::Error.
[[nodiscard]] Model loadMesh(const std::filesystem::path& path);

// A scene of the folder scenes by its name, or one that is made here: "bowl", a teapot in a bowl two kilometres wide,
// or "field", seventy teapots of a million triangles. Throws files::Error.
[[nodiscard]] Model loadModel(const std::string& name);

}
