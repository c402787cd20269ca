#pragma once
#include "values/progress.h"
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace files {

struct NamedLine {
    std::string name;
    int line;
};

// A face of five corners or more.
struct Polygon {
    int line;
    std::size_t firstTriangle; // of the n - 2 that its n corners make
    std::vector<uint32_t> corners; // indices of positions
};

// What an OBJ file holds beside its numbers.
struct ObjOutline {
    std::vector<NamedLine> libraries; // of each mtllib line
    std::vector<NamedLine> materials; // of each usemtl line
    std::vector<Polygon> polygons;
    std::size_t numTriangles = 0; // when each face of n corners makes n - 2
};

// Goes through the lines that we use: all numbers finite, all indices in range, faces of at least three corners.
// tinyobj checks none of these and names no lines. A step of the progress is a byte. Throws Error.
[[nodiscard]] ObjOutline checkObjSyntax(
    const std::filesystem::path& path, std::string_view text, values::Progress& progress);

}
