#include "files/obj_data.h"
#include "files/error.h"
#include "files/text.h"
#include <cmath>
#include <fstream>
#include <span>
#include <tiny_obj_loader.h>
#include <unordered_map>

namespace files {
namespace {

    // Keeps what tinyobj reads, line by line: the lists of faces that it makes otherwise take four times as long, and
    // twice the memory.
    class Collector {
    public:
        void read(std::istream& stream)
        {
            tinyobj::callback_t callbacks;
            callbacks.vertex_cb
                = [](void* self, float x, float y, float z, float) { of(self).m_data.positions.emplace_back(x, y, z); };
            callbacks.normal_cb
                = [](void* self, float x, float y, float z) { of(self).m_data.normals.emplace_back(x, y, z); };
            callbacks.texcoord_cb
                = [](void* self, float u, float v, float) { of(self).m_data.texCoords.emplace_back(u, v); };
            callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
                of(self).addFace({ corners, static_cast<std::size_t>(count) });
            };
            callbacks.usemtl_cb = [](void* self, const char* name, int) { of(self).useMaterial(name); };
            (void)tinyobj::LoadObjWithCallback(stream, callbacks, this); // tells nothing that checkObjSyntax does not
        }

        [[nodiscard]] ObjData take() { return std::move(m_data); }

    private:
        static Collector& of(void* self) { return *static_cast<Collector*>(self); }

        void addFace(std::span<const tinyobj::index_t> face)
        {
            if (face.size() > 3)
                m_data.fans.push_back({ m_data.triangles.size(), face.size() });
            for (std::size_t i = 2; i < face.size(); ++i) {
                m_data.triangles.push_back({ corner(face[0]), corner(face[i - 1]), corner(face[i]) });
                m_data.materials.push_back(m_material);
            }
        }

        [[nodiscard]] ObjCorner corner(const tinyobj::index_t& index) const
        {
            return { fromZero(index.vertex_index, m_data.positions.size()),
                fromZero(index.texcoord_index, m_data.texCoords.size()),
                fromZero(index.normal_index, m_data.normals.size()) };
        }

        // The file counts from 1, or from -1 backwards from the last so far; 0 stands for what is not given.
        static int fromZero(int index, std::size_t numSoFar)
        {
            return index < 0 ? static_cast<int>(numSoFar) + index : index - 1;
        }

        void useMaterial(std::string_view line)
        {
            const std::string name { takeWord(line) };
            const auto [entry, isNew] = m_materials.emplace(name, static_cast<int>(m_materials.size()));
            if (isNew)
                m_data.materialNames.push_back(name);
            m_material = entry->second;
        }

        ObjData m_data;
        std::unordered_map<std::string, int> m_materials;
        int m_material = -1;
    };

    // The line of the nth "v", "vn" or "vt".
    int lineOfNth(std::string_view text, std::string_view keyword, std::size_t n)
    {
        return lineOf(text, [&](std::string_view line) { return takeWord(line) == keyword && n-- == 0; });
    }

    template <typename Vector>
    void checkFinite(const std::filesystem::path& path, std::string_view keyword, const std::vector<Vector>& vectors)
    {
        for (std::size_t i = 0; i < vectors.size(); ++i)
            for (int j = 0; j < Vector::length(); ++j)
                if (!std::isfinite(vectors[i][j]))
                    throw Error(path, lineOfNth(readText(path), keyword, i),
                        "found a number out of range, expected a finite one");
    }

}

ObjData parseObj(const std::filesystem::path& path)
{
    std::ifstream stream = openToRead(path);
    Collector collector;
    collector.read(stream);
    return collector.take();
}

void checkFinite(const std::filesystem::path& path, const ObjData& data)
{
    checkFinite(path, "v", data.positions);
    checkFinite(path, "vn", data.normals);
    checkFinite(path, "vt", data.texCoords);
}

}
