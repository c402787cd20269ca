#include "files/obj_data.h"
#include "files/error.h"
#include "files/text.h"
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <tiny_obj_loader.h>

namespace files {
namespace {

    // Gives tinyobj, which asks for them at each mtllib line, the names of the materials that are read already.
    class MaterialNames : public tinyobj::MaterialReader {
    public:
        explicit MaterialNames(const std::vector<std::string>& names)
            : m_names(names)
        {
        }

        bool operator()(const std::string&, std::vector<tinyobj::material_t>*, std::map<std::string, int>* indices,
            std::string*, std::string*) override
        {
            for (std::size_t i = 0; i < m_names.size(); ++i)
                indices->emplace(m_names[i], static_cast<int>(i));
            return true;
        }

    private:
        const std::vector<std::string>& m_names;
    };

    // The line of the nth "v", "vn" or "vt".
    int lineOfNth(std::string_view text, std::string_view keyword, std::size_t n)
    {
        return lineOf(text, [&](std::string_view line) { return takeWord(line) == keyword && n-- == 0; });
    }

    // Where a number that we take for finite overflows within tinyobj, such as 0e999.
    void checkFinite(const std::filesystem::path& path, std::string_view keyword, const std::vector<float>& numbers,
        std::size_t numbersPerLine)
    {
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (!std::isfinite(numbers[i]))
                throw Error(path, lineOfNth(readText(path), keyword, i / numbersPerLine),
                    "found a number out of range, expected a finite one");
    }

    template <typename Vector> std::vector<Vector> grouped(const std::vector<float>& numbers)
    {
        constexpr auto length = static_cast<std::size_t>(Vector::length());
        std::vector<Vector> vectors(numbers.size() / length);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            vectors[i / length][static_cast<int>(i % length)] = numbers[i];
        return vectors;
    }

    void appendTriangles(const tinyobj::mesh_t& mesh, ObjData& data)
    {
        const auto corner = [&](std::size_t i) {
            const tinyobj::index_t& index = mesh.indices[i];
            return ObjCorner { index.vertex_index, index.texcoord_index, index.normal_index };
        };
        data.triangles.reserve(data.triangles.size() + mesh.indices.size() / 3);
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            data.triangles.push_back({ corner(i), corner(i + 1), corner(i + 2) });
        std::ranges::copy(mesh.material_ids, std::back_inserter(data.materials));
    }

}

ObjData parseObj(const std::filesystem::path& path, const std::vector<std::string>& materialNames)
{
    tinyobj::attrib_t numbers;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> unused;
    std::string warning, error;
    MaterialNames names(materialNames);
    std::ifstream stream = openToRead(path); // of a large file no copy is kept beside what is read
    constexpr bool triangulate = true, withColors = false;
    if (!tinyobj::LoadObj(&numbers, &shapes, &unused, &warning, &error, &stream, &names, triangulate, withColors))
        throw Error(path, error.substr(0, error.find('\n')));
    checkFinite(path, "v", numbers.vertices, 3);
    checkFinite(path, "vn", numbers.normals, 3);
    checkFinite(path, "vt", numbers.texcoords, 2);

    ObjData data { grouped<glm::vec3>(numbers.vertices), grouped<glm::vec3>(numbers.normals),
        grouped<glm::vec2>(numbers.texcoords), {}, {} };
    for (tinyobj::shape_t& shape : shapes) {
        appendTriangles(shape.mesh, data);
        shape = {}; // its memory is for the next
    }
    return data;
}

}
