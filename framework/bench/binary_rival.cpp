#include "accel/builder.h"
#include "accel/traversal.h"
#include "bench/closest_only_rival.h"
#include "values/scene_of.h"

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

    class BinaryRival : public ClosestOnlyRival {
    public:
        explicit BinaryRival(accel::Tree tree)
            : m_tree(std::move(tree))
        {
            name = "binary";
            numBytes = m_tree.nodes().size_bytes() + m_tree.primitives().size_bytes();
        }

    private:
        [[nodiscard]] bool intersect(Ray& ray) const override
        {
            accel::TriangleHit hit;
            return accel::findClosest(m_tree, ray, hit) != nullptr;
        }

        PlainTree m_tree;
    };

}

void addBinary(std::span<const Triangle> triangles, Rivals& rivals)
{
    const Scene scene = values::sceneOf(triangles);
    accel::Tree tree;
    const double seconds = buildSecondsOf(tree, [&] {
        accel::Tree built = accel::buildTree(scene, 4);
        (void)built.primitives.all(); // made now, while there is a scene
        return built;
    });
    rivals.push_back(std::make_unique<BinaryRival>(std::move(tree)));
    rivals.back()->buildSeconds = seconds;
}

}
