#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace files {

// Indices from 0, of normals and texture coordinates -1 for none.
struct ObjCorner {
    int position, texCoord, normal;

    [[nodiscard]] bool operator==(const ObjCorner&) const = default;
};

// The contents of an OBJ file, its groups put together; triangles in the order of the file.
struct ObjData {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> texCoords;
    std::vector<std::array<ObjCorner, 3>> triangles;
    std::vector<int> materials; // one a triangle, an index into materialNames; -1: none
};

// The file has passed checkObjSyntax. Throws Error.
[[nodiscard]] ObjData parseObj(const std::filesystem::path& path, const std::vector<std::string>& materialNames);

}
