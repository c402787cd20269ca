#include "debug/texels.h"

namespace debug {
namespace {

    // Columns and rows from `first` up to `end`, which is beyond them.
    struct Part {
        glm::ivec2 first { 0 }, end { 0 };
    };

    class Search {
    public:
        Search(const SampleTexture& sample, glm::ivec2 size, const glm::vec2& texCoord)
            : m_sample(sample)
            , m_texCoord(texCoord)
            , m_image(size.x, size.y, 1)
        {
        }

        // Halves whatever has weight until it is a texel.
        void look(const Part& part)
        {
            const glm::ivec2 size = part.end - part.first;
            const float weight = weightOf(part);
            constexpr float least = 1e-4f; // below it is rounding
            if (!(weight > least))
                return;
            if (size == glm::ivec2(1)) {
                texels.push_back({ part.first, weight });
                return;
            }
            const int axis = size.x >= size.y ? 0 : 1;
            Part lower = part, upper = part;
            lower.end[axis] = upper.first[axis] = part.first[axis] + size[axis] / 2;
            look(lower);
            look(upper);
        }

        std::vector<Texel> texels;

    private:
        float weightOf(const Part& part)
        {
            fill(part, 255);
            const float weight = m_sample(m_image, m_texCoord).x;
            fill(part, 0);
            return weight;
        }

        void fill(const Part& part, uint8_t value)
        {
            for (int y = part.first.y; y < part.end.y; ++y) {
                uint8_t* const row = m_image.get_data() + static_cast<std::ptrdiff_t>(y) * m_image.width;
                std::fill(row + part.first.x, row + part.end.x, value);
            }
        }

        const SampleTexture& m_sample;
        glm::vec2 m_texCoord;
        Image m_image;
    };

}

std::vector<Texel> texelsOf(const SampleTexture& sample, glm::ivec2 size, const glm::vec2& texCoord)
{
    Search search { sample, size, texCoord };
    search.look({ glm::ivec2(0), size });
    return std::move(search.texels);
}

}
