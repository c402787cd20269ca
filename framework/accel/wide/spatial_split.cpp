#include "accel/wide/spatial_split.h"
#include <algorithm>

namespace accel::wide {
namespace {

    constexpr std::size_t maxBins = 16;

    // Few references show few places to cut.
    std::size_t binsFor(std::size_t numReferences)
    {
        return std::min(maxBins, 4 + numReferences / 8);
    }

    class SpatialBins {
    public:
        SpatialBins(const Box& bounds, int axis, std::size_t numBins)
            : m_axis(axis)
            , m_numBins(numBins)
            , m_origin(bounds.lower[axis])
            , m_size((bounds.upper[axis] - bounds.lower[axis]) / static_cast<float>(numBins))
        {
            m_boxes.fill(Box::empty());
        }

        void add(const Reference& reference, const Triangle& triangle)
        {
            const std::size_t first = binOf(reference.box.lower[m_axis]);
            const std::size_t last = std::max(first, binOf(reference.box.upper[m_axis]));
            ++m_begin[first];
            ++m_end[last];
            if (first == last)
                m_boxes[first].add(reference.box);
            else
                addParts(reference.box, triangle, first, last);
        }

        void search(std::size_t numReferences, uint32_t maxCut, SpatialSplit& best) const
        {
            std::array<Box, maxBins> above;
            above[m_numBins - 1] = m_boxes[m_numBins - 1];
            for (std::size_t i = m_numBins - 1; i-- > 0;)
                above[i] = unite(m_boxes[i], above[i + 1]);

            Box box = Box::empty();
            uint32_t numBelow = 0, numAbove = static_cast<uint32_t>(numReferences);
            for (std::size_t i = 1; i < m_numBins; ++i) {
                box.add(m_boxes[i - 1]);
                numBelow += m_begin[i - 1];
                numAbove -= m_end[i - 1];
                const uint32_t numCut = numBelow + numAbove - static_cast<uint32_t>(numReferences);
                const float cost = box.halfArea() * static_cast<float>(numBelow)
                    + above[i].halfArea() * static_cast<float>(numAbove);
                if (cost < best.cost && numCut <= maxCut && numBelow > 0 && numAbove > 0)
                    best = { cost, m_axis, plane(i), numCut };
            }
        }

    private:
        // What of the triangle lies in each of these bins: its corners, and where its edges cross the planes between.
        // But for rounding, which an estimate does not mind.
        void addParts(const Box& box, const Triangle& triangle, std::size_t first, std::size_t last)
        {
            std::array<Box, maxBins> parts;
            std::fill(parts.begin() + first, parts.begin() + last + 1, Box::empty());
            const auto partOf = [&](float position) { return std::clamp(binOf(position), first, last); };
            Float4 from = toFloat4(triangle[2]);
            std::size_t fromPart = partOf(from[m_axis]);
            for (const glm::vec3& corner : triangle) {
                const Float4 to = toFloat4(corner);
                const std::size_t toPart = partOf(to[m_axis]);
                parts[toPart].add(to);
                const Float4 slope = (to - from) / (to[m_axis] - from[m_axis]);
                for (std::size_t i = std::min(fromPart, toPart); i < std::max(fromPart, toPart); ++i) {
                    const Float4 point = from + (plane(i + 1) - from[m_axis]) * slope;
                    parts[i].add(point);
                    parts[i + 1].add(point);
                }
                from = to;
                fromPart = toPart;
            }
            for (std::size_t i = first; i <= last; ++i)
                m_boxes[i].add(intersect(parts[i], box));
        }

        [[nodiscard]] std::size_t binOf(float position) const
        {
            const float bin = (position - m_origin) / m_size;
            return static_cast<std::size_t>(std::clamp(bin, 0.0f, static_cast<float>(m_numBins - 1)));
        }

        [[nodiscard]] float plane(std::size_t bin) const { return m_origin + static_cast<float>(bin) * m_size; }

        int m_axis;
        std::size_t m_numBins;
        float m_origin, m_size;
        std::array<Box, maxBins> m_boxes;
        std::array<uint32_t, maxBins> m_begin {}, m_end {};
    };

}

SpatialSplit findSpatialSplit(
    std::span<const Reference> references, const Box& bounds, std::span<const Triangle> triangles, uint32_t maxCut)
{
    SpatialSplit best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(bounds.upper[axis] - bounds.lower[axis] > 1e-30f))
            continue;
        SpatialBins bins(bounds, axis, binsFor(references.size()));
        for (const Reference& reference : references)
            bins.add(reference, triangles[reference.primitive()]);
        bins.search(references.size(), maxCut, best);
    }
    return best;
}

}
