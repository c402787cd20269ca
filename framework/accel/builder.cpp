#include "accel/builder.h"
#include "accel/bounds.h"
#include "accel/kept_trees.h"
#include "accel/scene_triangles.h"
#include "files/digest.h"
#include <algorithm>
#include <array>
#include <span>

namespace accel {
namespace {

    using Node = BVHInterface::Node;

    // What the builder needs of a triangle: no more, since there is one of each at once with what it builds.
    struct Reference {
        AxisAlignedBox bounds;
        uint32_t index; // counted over all meshes

        [[nodiscard]] glm::vec3 centroid() const { return 0.5f * bounds.lower + 0.5f * bounds.upper; }
    };

    struct Split {
        int axis = -1; // -1: none
        float position = 0.0f;
        float cost = std::numeric_limits<float>::infinity();
    };

    constexpr int numBins = 16;
    constexpr float traversalCost = 1.0f; // in triangle tests
    constexpr uint32_t medianLevel
        = maxLevels / 2; // from here halves: 2^32 triangles fit into the levels that are left

    struct Bin {
        AxisAlignedBox bounds = emptyBox();
        uint32_t count = 0;

        void add(const Bin& other)
        {
            bounds = unite(bounds, other.bounds);
            count += other.count;
        }
    };

    std::vector<Reference> makeReferences(const SceneTriangles& triangles)
    {
        std::vector<Reference> references;
        references.reserve(triangles.size());
        for (uint32_t i = 0; i < triangles.size(); ++i)
            references.push_back({ boundsOf(triangles[i]), i });
        return references;
    }

    float costOf(const Bin& bin)
    {
        return bin.count == 0 ? 0.0f : halfArea(bin.bounds) * static_cast<float>(bin.count);
    }

    Split bestSplitOnAxis(std::span<const Reference> references, const AxisAlignedBox& centroids, int axis)
    {
        const float lower = centroids.lower[axis];
        const float extent = centroids.upper[axis] - lower;
        if (!(extent > 0.0f))
            return {};

        std::array<Bin, numBins> bins;
        for (const Reference& r : references) {
            const auto bin = static_cast<int>((r.centroid()[axis] - lower) / extent * static_cast<float>(numBins));
            bins[static_cast<std::size_t>(std::min(bin, numBins - 1))].add({ r.bounds, 1 });
        }

        std::array<float, numBins> costAbove {};
        Bin above;
        for (std::size_t i = numBins - 1; i > 0; --i) {
            above.add(bins[i]);
            costAbove[i] = costOf(above);
        }
        Split best;
        Bin below;
        for (std::size_t i = 1; i < numBins; ++i) {
            below.add(bins[i - 1]);
            const float cost = costOf(below) + costAbove[i];
            if (cost < best.cost)
                best = { axis, lower + extent * static_cast<float>(i) / static_cast<float>(numBins), cost };
        }
        return best;
    }

    Split bestSplit(std::span<const Reference> references, const AxisAlignedBox& centroids)
    {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            const Split split = bestSplitOnAxis(references, centroids, axis);
            if (split.cost < best.cost)
                best = split;
        }
        return best;
    }

    // All of a tree but what its triangles look like.
    struct Shape {
        std::vector<Node> nodes;
        std::vector<uint32_t> order; // of the triangles
        uint32_t numLevels = 0, numLeaves = 0;
    };

    class Builder {
    public:
        Builder(std::span<Reference> references, uint32_t leafSize, Shape& shape)
            : m_references(references)
            , m_leafSize(leafSize)
            , m_shape(shape)
        {
        }

        void build()
        {
            m_shape.nodes.reserve(m_references.size() + 1);
            m_shape.nodes.emplace_back();
            buildNode(0, 0, static_cast<uint32_t>(m_references.size()), 1);
        }

    private:
        void buildNode(uint32_t node, uint32_t first, uint32_t count, uint32_t level)
        {
            const auto references = m_references.subspan(first, count);
            AxisAlignedBox bounds = emptyBox();
            AxisAlignedBox centroids = emptyBox();
            for (const Reference& r : references) {
                bounds = unite(bounds, r.bounds);
                centroids = unite(centroids, r.centroid());
            }
            m_shape.nodes[node].aabb = bounds;

            const uint32_t below = splitReferences(references, bounds, centroids, level);
            if (below == 0)
                return makeLeaf(node, first, count, level);
            const auto left = static_cast<uint32_t>(m_shape.nodes.size());
            m_shape.nodes.resize(left + 2); // siblings share a cache line
            m_shape.nodes[node].data = { left, left + 1 };
            buildNode(left, first, below, level + 1);
            buildNode(left + 1, first + below, count - below, level + 1);
        }

        // Reorders the references; returns how many go to the left, 0 for a leaf.
        uint32_t splitReferences(std::span<Reference> references, const AxisAlignedBox& bounds,
            const AxisAlignedBox& centroids, uint32_t level) const
        {
            const auto count = static_cast<uint32_t>(references.size());
            if (count <= 1)
                return 0;
            const Split split = level < medianLevel ? bestSplit(references, centroids) : Split {};
            const float leafCost = halfArea(bounds) * (static_cast<float>(count) - traversalCost);
            if (count <= m_leafSize && !(split.cost < leafCost))
                return 0;
            const auto isBelow = [&](const Reference& r) { return r.centroid()[split.axis] < split.position; };
            const auto middle
                = split.axis < 0 ? references.begin() : std::partition(references.begin(), references.end(), isBelow);
            const auto below = static_cast<uint32_t>(middle - references.begin());
            if (below == 0 || below == count) // coinciding centroids: any halves will do
                return count / 2;
            return below;
        }

        void makeLeaf(uint32_t node, uint32_t first, uint32_t count, uint32_t level)
        {
            m_shape.nodes[node].data = { Node::LeafBit | first, count };
            m_shape.numLevels = std::max(m_shape.numLevels, level);
            ++m_shape.numLeaves;
        }

        std::span<Reference> m_references;
        uint32_t m_leafSize;
        Shape& m_shape;
    };

    Shape buildShape(const SceneTriangles& triangles, uint32_t leafSize)
    {
        std::vector<Reference> references = makeReferences(triangles);
        Shape shape;
        Builder(references, leafSize, shape).build();
        shape.order.reserve(references.size());
        for (const Reference& reference : references)
            shape.order.push_back(reference.index);
        return shape;
    }

    // To be changed with what a node means, or where the builder puts it.
    constexpr std::string_view keptVersion = "binary tree 1";

    std::string nameOf(const Scene& scene, uint32_t leafSize)
    {
        files::Digest digest;
        digest.add(keptVersion).add(std::to_string(leafSize));
        for (const Mesh& mesh : scene.meshes)
            digest.add(std::as_bytes(std::span(mesh.vertices))).add(std::as_bytes(std::span(mesh.triangles)));
        return digest.hex();
    }

    // As it was kept or, built now, will be.
    Shape shapeKeptIn(const files::KeptArrays& folder, const Scene& scene, uint32_t leafSize)
    {
        const std::string name = nameOf(scene, leafSize);
        Shape shape;
        if (folder.load(name, shape.nodes, shape.order, shape.numLevels, shape.numLeaves))
            return shape;
        shape = buildShape(SceneTriangles(scene.meshes), leafSize);
        folder.save(name, shape.nodes, shape.order, shape.numLevels, shape.numLeaves);
        return shape;
    }

}

Tree buildTree(const Scene& scene, uint32_t leafSize)
{
    SceneTriangles triangles(scene.meshes);
    const files::KeptArrays* const kept = keptTrees(triangles.size());
    Shape shape = kept ? shapeKeptIn(*kept, scene, leafSize) : buildShape(triangles, leafSize);
    return { std::move(shape.nodes), { std::move(triangles), std::move(shape.order) }, shape.numLevels,
        shape.numLeaves };
}

}
