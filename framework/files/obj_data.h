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

using ObjTriangle = std::array<ObjCorner, 3>;

// A face of four corners or more, as triangles that all begin at its first.
struct ObjFan {
    std::size_t firstTriangle, numCorners;
};

// The contents of an OBJ file, its groups put together; triangles in the order of the file.
struct ObjData {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> texCoords;
    std::vector<ObjTriangle> triangles;
    std::vector<ObjFan> fans; // of them
    std::vector<int> materials; // one a triangle, an index into materialNames; -1: none
    std::vector<std::string> materialNames; // in use, each once
};

// Of a file that does not pass checkObjSyntax, indices may lead nowhere. Throws Error.
[[nodiscard]] ObjData parseObj(const std::filesystem::path& path);

// Where a number that checkObjSyntax takes for finite overflows within tinyobj, such as 0e999. Throws Error.
void checkFinite(const std::filesystem::path& path, const ObjData& data);

}
