#include "accel/wide/spatial_split.h"
#include "accel/wide/clip.h"
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

        // Cuts the reference at every plane between the bins that it reaches into.
        void add(const Reference& reference, const Triangle& triangle)
        {
            const std::size_t first = binOf(reference.box.lower[m_axis]);
            const std::size_t last = std::max(first, binOf(reference.box.upper[m_axis]));
            ++m_begin[first];
            ++m_end[last];
            Box rest = reference.box;
            for (std::size_t bin = first; bin < last; ++bin) {
                const Halves halves = clip(rest, triangle, m_axis, plane(bin + 1));
                m_boxes[bin].add(halves.lower);
                rest = halves.upper;
            }
            m_boxes[last].add(rest);
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
