#include "files/mtl.h"
#include "files/error.h"
#include "files/text.h"
#include <algorithm>
#include <cfloat>
#include <tiny_obj_loader.h>

namespace files {
namespace {

    class MtlReader {
    public:
        explicit MtlReader(const std::filesystem::path& path)
            : m_path(path)
        {
        }

        std::vector<MtlMaterial> read(std::string_view text)
        {
            while (!text.empty()) {
                ++m_line;
                readLine(takeLine(text));
            }
            return m_materials;
        }

    private:
        void readLine(std::string_view line)
        {
            const std::string_view keyword = takeWord(line);
            if (keyword == "newmtl")
                return startMaterial(line);
            constexpr std::string_view known[] { "Kd", "Ks", "Ns", "d", "Tr", "map_Kd" };
            if (std::ranges::find(known, keyword) == std::end(known))
                return;
            if (m_materials.empty())
                fail("found " + std::string(keyword) + ", expected newmtl before it");
            readProperty(m_materials.back(), keyword, line);
        }

        void startMaterial(std::string_view line)
        {
            m_hasDissolve = false;
            // tinyobj, too, takes the first word alone of the name in usemtl.
            m_materials.push_back({ .name = std::string(takeWord(line)), .file = m_path });
        }

        void readProperty(MtlMaterial& target, std::string_view keyword, std::string_view line)
        {
            Material& material = target.material;
            if (keyword == "Kd")
                material.kd = readColor(line);
            else if (keyword == "Ks")
                material.ks = readColor(line);
            else if (keyword == "Ns")
                material.shininess = readNumber(line, FLT_MAX);
            else if (keyword == "d") {
                material.transparency = readNumber(line, 1.0f);
                m_hasDissolve = true;
            } else if (keyword == "Tr") {
                const float through = readNumber(line, 1.0f);
                if (!m_hasDissolve) // exporters disagree on the sense of Tr: d is the one to trust
                    material.transparency = 1.0f - through;
            } else
                readTexture(target, line);
        }

        void readTexture(MtlMaterial& target, std::string_view line)
        {
            std::string name(trimmed(line));
            if (name.starts_with('-')) { // options, of which the framework has none
                tinyobj::texture_option_t ignored;
                tinyobj::ParseTextureNameAndOption(&name, &ignored, std::string(trimmed(line)).c_str());
            }
            if (name.empty())
                fail("found map_Kd without a name, expected that of a picture");
            std::ranges::replace(name, '\\', '/'); // as exporters on Windows write it
            target.texture = m_path.parent_path() / name;
            target.textureLine = m_line;
        }

        // A single number stands for all three.
        glm::vec3 readColor(std::string_view line)
        {
            glm::vec3 color(readNumber(line, 1.0f));
            for (int c = 1; c < 3 && !trimmed(line).empty(); ++c)
                color[c] = readNumber(line, 1.0f);
            return color;
        }

        float readNumber(std::string_view& line, float highest)
        {
            const std::string_view word = takeWord(line);
            const auto number = parseNumber(word);
            if (!number || *number < 0.0f || *number > highest)
                fail("found " + (word.empty() ? "the end of the line" : '"' + std::string(word) + '"')
                    + ", expected a number " + (highest == 1.0f ? "in [0, 1]" : "of at least 0"));
            return *number;
        }

        [[noreturn]] void fail(const std::string& message) const { throw Error(m_path, m_line, message); }

        const std::filesystem::path& m_path;
        int m_line = 0;
        bool m_hasDissolve = false;
        std::vector<MtlMaterial> m_materials;
    };

}

std::vector<MtlMaterial> loadMtl(const std::filesystem::path& path)
{
    const std::string text = readText(path);
    return MtlReader(path).read(text);
}

}
