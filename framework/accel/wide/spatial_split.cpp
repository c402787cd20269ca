#include "accel/wide/spatial_split.h"
#include "accel/wide/in_parts.h"
#include <algorithm>

namespace accel::wide {
namespace {

    constexpr uint32_t maxBins = 16;

    // Few references show few places to cut.
    int binsFor(uint32_t numReferences)
    {
        return static_cast<int>(std::min(maxBins, 4 + numReferences / 8));
    }

    class SpatialBins {
    public:
        SpatialBins(const Box& bounds, uint32_t numReferences)
            : m_numReferences(numReferences)
            , m_numBins(binsFor(numReferences))
            , m_origin(bounds.lower)
            , m_size((bounds.upper - bounds.lower) / static_cast<float>(m_numBins))
        {
            m_origin[3] = m_size[3] = 1.0f; // nobody looks there, but numbers too small to be normal take long
            for (int axis = 0; axis < 4; ++axis)
                m_scale[axis] = m_size[axis] > 1e-30f ? 1.0f / m_size[axis] : 0.0f;
            for (auto& boxes : m_boxes)
                std::fill_n(boxes, m_numBins, Box::empty());
        }

        void add(const SpatialBins& other)
        {
            for (int axis = 0; axis < 3; ++axis) {
                for (int i = 0; i < m_numBins; ++i) {
                    m_boxes[axis][i].add(other.m_boxes[axis][i]);
                    m_begin[axis][i] += other.m_begin[axis][i];
                    m_end[axis][i] += other.m_end[axis][i];
                }
            }
        }

        void add(const Reference& reference, const Triangles& triangles)
        {
            const Int4 first = binOf(reference.box.lower), last = binOf(reference.box.upper);
            bool isWhole[3];
            for (int axis = 0; axis < 3; ++axis) {
                ++m_begin[axis][first[axis]];
                ++m_end[axis][last[axis]];
                isWhole[axis] = first[axis] == last[axis];
                if (isWhole[axis])
                    m_boxes[axis][first[axis]].add(reference.box);
            }
            if (isWhole[0] && isWhole[1] && isWhole[2])
                return;
            const Triangle triangle = triangles[reference.primitive()];
            for (int axis = 0; axis < 3; ++axis)
                if (!isWhole[axis])
                    addParts(reference.box, triangle, axis, first[axis], last[axis]);
        }

        [[nodiscard]] SpatialSplit best(uint32_t maxCut) const
        {
            SpatialSplit best;
            for (int axis = 0; axis < 3; ++axis)
                if (m_scale[axis] > 0.0f)
                    search(axis, maxCut, best);
            return best;
        }

    private:
        using Int4 = int __attribute__((vector_size(16)));

        // What of the triangle lies in each of these bins: its corners, and where its edges cross the planes between.
        // But for rounding, which an estimate does not mind.
        void addParts(const Box& box, const Triangle& triangle, int axis, int first, int last)
        {
            Box parts[maxBins];
            std::fill(parts + first, parts + last + 1, Box::empty());
            Float4 from = toFloat4(triangle[2]);
            int fromPart = std::clamp(binOf(from)[axis], first, last);
            for (const glm::vec3& corner : triangle) {
                const Float4 to = toFloat4(corner);
                const int toPart = std::clamp(binOf(to)[axis], first, last);
                parts[toPart].add(to);
                if (fromPart != toPart) {
                    const Float4 slope = (to - from) / (to[axis] - from[axis]);
                    for (int i = std::min(fromPart, toPart); i < std::max(fromPart, toPart); ++i) {
                        const Float4 point = from + (plane(axis, i + 1) - from[axis]) * slope;
                        parts[i].add(point);
                        parts[i + 1].add(point);
                    }
                }
                from = to;
                fromPart = toPart;
            }
            for (int i = first; i <= last; ++i)
                m_boxes[axis][i].add(intersect(parts[i], box));
        }

        void search(int axis, uint32_t maxCut, SpatialSplit& best) const
        {
            const Box* const boxes = m_boxes[axis];
            Box above[maxBins];
            above[m_numBins - 1] = boxes[m_numBins - 1];
            for (int i = m_numBins - 1; i-- > 0;)
                above[i] = unite(boxes[i], above[i + 1]);

            Box box = Box::empty();
            uint32_t numBelow = 0, numAbove = m_numReferences;
            for (int i = 1; i < m_numBins; ++i) {
                box.add(boxes[i - 1]);
                numBelow += m_begin[axis][i - 1];
                numAbove -= m_end[axis][i - 1];
                const uint32_t numCut = numBelow + numAbove - m_numReferences;
                const float cost = box.halfArea() * static_cast<float>(numBelow)
                    + above[i].halfArea() * static_cast<float>(numAbove);
                if (cost < best.cost && numCut <= maxCut && numBelow > 0 && numAbove > 0)
                    best = { cost, axis, plane(axis, i), numCut };
            }
        }

        [[nodiscard]] Int4 binOf(Float4 position) const
        {
            const Float4 bin = (position - m_origin) * m_scale, last = Float4 {} + static_cast<float>(m_numBins - 1);
            return __builtin_convertvector(min(max(bin, Float4 {}), last), Int4);
        }

        [[nodiscard]] float plane(int axis, int bin) const
        {
            return m_origin[axis] + static_cast<float>(bin) * m_size[axis];
        }

        uint32_t m_numReferences;
        int m_numBins;
        Float4 m_origin, m_size, m_scale;
        Box m_boxes[3][maxBins];
        uint32_t m_begin[3][maxBins] {}, m_end[3][maxBins] {};
    };

}

SpatialSplit findSpatialSplit(
    std::span<const Reference> references, const Box& bounds, const Triangles& triangles, uint32_t maxCut)
{
    SpatialBins bins(bounds, static_cast<uint32_t>(references.size()));
    addInParts(bins, static_cast<uint32_t>(references.size()), [&](SpatialBins& sum, uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i)
            sum.add(references[i], triangles);
    });
    return bins.best(maxCut);
}

}
