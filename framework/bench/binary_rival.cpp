#include "accel/builder.h"
#include "accel/traversal.h"
#include "bench/clock.h"
#include "bench/rival.h"

namespace bench {
namespace {

    // A tree behind the interface of a submission, for the traversal alone.
    class PlainTree : public BVHInterface {
    public:
        explicit PlainTree(accel::Tree tree)
            : m_tree(std::move(tree))
        {
        }

        bool intersect(RenderState&, Ray&, HitInfo&) const override { return false; }
        [[nodiscard]] std::span<const Node> nodes() const override { return m_tree.nodes; }
        [[nodiscard]] std::span<Node> nodes() override { return m_tree.nodes; }
        [[nodiscard]] std::span<const Primitive> primitives() const override { return m_tree.primitives; }
        [[nodiscard]] std::span<Primitive> primitives() override { return m_tree.primitives; }
        [[nodiscard]] uint32_t numLevels() const override { return m_tree.numLevels; }
        [[nodiscard]] uint32_t numLeaves() const override { return m_tree.numLeaves; }

    private:
        accel::Tree m_tree;
    };

    class BinaryRival : public Rival {
    public:
        explicit BinaryRival(accel::Tree tree)
            : m_tree(std::move(tree))
        {
            name = "binary";
            numBytes = m_tree.nodes().size_bytes() + m_tree.primitives().size_bytes();
        }

        void load(std::span<const Ray> rays) override { m_rays.assign(rays.begin(), rays.end()); }

        void traceClosest() override
        {
            m_distances.clear();
            for (Ray ray : m_rays) {
                accel::TriangleHit hit;
                const bool isHit = accel::findClosest(m_tree, ray, hit) != nullptr;
                m_distances.push_back(isHit ? ray.t : std::numeric_limits<float>::infinity());
            }
        }

        void traceOccluded() override { traceClosest(); } // it knows no better

        [[nodiscard]] float distance(std::size_t ray) const override { return m_distances[ray]; }
        [[nodiscard]] bool isOccluded(std::size_t ray) const override { return std::isfinite(m_distances[ray]); }

    private:
        PlainTree m_tree;
        std::vector<Ray> m_rays;
        std::vector<float> m_distances;
    };

    Scene sceneOf(std::span<const Triangle> triangles)
    {
        Scene scene;
        Mesh& mesh = scene.meshes.emplace_back();
        for (const Triangle& triangle : triangles) {
            const auto first = static_cast<uint32_t>(mesh.vertices.size());
            for (const glm::vec3& corner : triangle)
                mesh.vertices.push_back({ corner, {}, {} });
            mesh.triangles.emplace_back(first, first + 1, first + 2);
        }
        return scene;
    }

}

void addBinary(std::span<const Triangle> triangles, Rivals& rivals)
{
    const Scene scene = sceneOf(triangles);
    accel::Tree tree;
    const double seconds = secondsOf([&] { tree = accel::buildTree(scene, 4); });
    rivals.push_back(std::make_unique<BinaryRival>(std::move(tree)));
    rivals.back()->buildSeconds = seconds;
}

}
