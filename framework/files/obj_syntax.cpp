#include "files/obj_syntax.h"
#include "files/error.h"
#include "files/text.h"
#include <array>
#include <charconv>

namespace files {
namespace {

    struct Kind {
        std::string_view keyword;
        std::string_view plural;
        int minNumbers, maxNumbers; // expected, read
        int count = 0;
        int highestIndex = 0; // a positive index may come before what it names
        int lineOfHighest = 0;
    };

    class Checker {
    public:
        Checker(const std::filesystem::path& path, values::Progress& progress)
            : m_path(path)
            , m_progress(progress)
        {
        }

        ObjOutline check(std::string_view text)
        {
            m_progress.expect(text.size());
            while (!text.empty()) {
                ++m_line;
                const std::size_t before = text.size();
                checkLine(takeLine(text));
                m_progress.add(before - text.size());
            }
            for (const Kind& kind : m_kinds)
                if (kind.highestIndex > kind.count) {
                    m_line = kind.lineOfHighest;
                    failIndex(std::to_string(kind.highestIndex), kind);
                }
            return m_outline;
        }

    private:
        void checkLine(std::string_view line)
        {
            const std::string_view keyword = takeWord(line);
            if (keyword == "f" || keyword == "l" || keyword == "p")
                return checkCorners(keyword, line);
            if (keyword == "mtllib")
                m_outline.libraries.push_back({ std::string(trimmed(line)), m_line });
            if (keyword == "usemtl")
                m_outline.materials.push_back({ std::string(takeWord(line)), m_line });
            for (Kind& kind : m_kinds)
                if (kind.keyword == keyword)
                    return checkNumbers(kind, line);
        }

        void checkNumbers(Kind& kind, std::string_view line)
        {
            ++kind.count;
            for (int i = 0; i < kind.maxNumbers; ++i) {
                const std::string_view word = takeWord(line);
                if (word.empty() && i >= kind.minNumbers)
                    return;
                if (!parseNumber(word))
                    fail("found " + (word.empty() ? "the end of the line" : '"' + std::string(word) + '"')
                        + ", expected a number");
            }
        }

        void checkCorners(std::string_view keyword, std::string_view line)
        {
            std::vector<uint32_t> corners;
            for (auto corner = takeWord(line); !corner.empty(); corner = takeWord(line))
                corners.push_back(checkCorner(corner));
            if (keyword != "f")
                return;
            const std::size_t count = corners.size();
            if (count < 3)
                fail("found a face of " + std::to_string(count) + " corners, expected at least 3");
            if (count > 4)
                m_outline.polygons.push_back({ m_line, m_outline.numTriangles, std::move(corners) });
            m_outline.numTriangles += count - 2;
        }

        // Takes v, v/vt, v/vt/vn or v//vn; returns the index of the position.
        uint32_t checkCorner(std::string_view corner)
        {
            const std::size_t slash = std::min(corner.find('/'), corner.size());
            const uint32_t position = checkIndex(m_kinds[0], corner.substr(0, slash), corner);
            if (slash == corner.size())
                return position;
            const std::string_view rest = corner.substr(slash + 1);
            const std::size_t second = std::min(rest.find('/'), rest.size());
            if (second != 0 || rest.empty())
                checkIndex(m_kinds[1], rest.substr(0, second), corner);
            if (second != rest.size())
                checkIndex(m_kinds[2], rest.substr(second + 1), corner);
            return position;
        }

        uint32_t checkIndex(Kind& kind, std::string_view word, std::string_view corner)
        {
            int index = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
            if (error == std::errc::invalid_argument || end != word.data() + word.size())
                fail("found \"" + std::string(corner) + "\", expected indices as 1, 1/1, 1/1/1 or 1//1");
            if (error != std::errc {} || index == 0 || index < -kind.count)
                failIndex(std::string(word), kind);
            if (index > kind.highestIndex) {
                kind.highestIndex = index;
                kind.lineOfHighest = m_line;
            }
            return static_cast<uint32_t>(index > 0 ? index - 1 : kind.count + index);
        }

        [[noreturn]] void failIndex(const std::string& found, const Kind& kind) const
        {
            const std::string count = std::to_string(kind.count);
            const std::string expected = kind.count == 0
                ? "none as there are no " + std::string(kind.plural)
                : "1 to " + count + " or -" + count + " to -1 of the " + std::string(kind.plural);
            fail("found the index " + found + ", expected " + expected);
        }

        [[noreturn]] void fail(const std::string& message) const { throw Error(m_path, m_line, message); }

        const std::filesystem::path& m_path;
        values::Progress& m_progress;
        int m_line = 0;
        std::array<Kind, 3> m_kinds { // in the order of a corner
            Kind { "v", "positions", 3, 3 }, Kind { "vt", "texture coordinates", 1, 2 }, Kind { "vn", "normals", 3, 3 }
        };
        ObjOutline m_outline;
    };

}

ObjOutline checkObjSyntax(const std::filesystem::path& path, std::string_view text, values::Progress& progress)
{
    return Checker(path, progress).check(text);
}

}
