#include "bench/closest_only_rival.h"
#include "bvh_interface.h"
#include "intersect.h"
#include <algorithm>

namespace bench {
namespace {

    using Primitive = BVHInterface::Primitive;

    // A first tree, as many write it: halves of the triangles along the longest axis; both children are asked, in no
    // order; a hit is described whenever one is found, all that HitInfo has.
    class NaiveTree {
    public:
        explicit NaiveTree(std::span<const Triangle> triangles)
        {
            for (const auto& [a, b, c] : triangles) {
                const glm::vec3 normal = glm::cross(b - a, c - a);
                m_primitives.push_back({ 0, { a, normal, {} }, { b, normal, {} }, { c, normal, {} } });
            }
            m_root = build(m_primitives);
        }

        bool intersect(Ray& ray, HitInfo& hitInfo) const { return intersect(*m_root, ray, hitInfo); }

    private:
        struct Node {
            AxisAlignedBox box;
            std::span<const Primitive> primitives; // of a leaf
            std::unique_ptr<Node> left, right;
        };

        static AxisAlignedBox boxOf(std::span<const Primitive> primitives)
        {
            AxisAlignedBox box { glm::vec3(std::numeric_limits<float>::max()),
                glm::vec3(std::numeric_limits<float>::lowest()) };
            for (const Primitive& p : primitives) {
                for (const Vertex& v : { p.v0, p.v1, p.v2 }) {
                    box.lower = glm::min(box.lower, v.position);
                    box.upper = glm::max(box.upper, v.position);
                }
            }
            return box;
        }

        static int longestAxis(const AxisAlignedBox& box)
        {
            const glm::vec3 size = box.upper - box.lower;
            return size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
        }

        static float centroid(const Primitive& p, int axis)
        {
            return (p.v0.position[axis] + p.v1.position[axis] + p.v2.position[axis]) / 3.0f;
        }

        static std::unique_ptr<Node> build(std::span<Primitive> primitives)
        {
            auto node = std::make_unique<Node>();
            node->box = boxOf(primitives);
            constexpr std::size_t leafSize = 4;
            if (primitives.size() <= leafSize) {
                node->primitives = primitives;
                return node;
            }
            const std::size_t half = primitives.size() / 2;
            const auto less = [axis = longestAxis(node->box)](const Primitive& a, const Primitive& b) {
                return centroid(a, axis) < centroid(b, axis);
            };
            std::ranges::nth_element(primitives, primitives.begin() + static_cast<std::ptrdiff_t>(half), less);
            node->left = build(primitives.first(half));
            node->right = build(primitives.subspan(half));
            return node;
        }

        bool intersect(const Node& node, Ray& ray, HitInfo& hitInfo) const
        {
            Ray toBox = ray; // the box would shorten the ray
            if (!intersectRayWithShape(node.box, toBox))
                return false;
            if (node.left) {
                const bool hitLeft = intersect(*node.left, ray, hitInfo);
                const bool hitRight = intersect(*node.right, ray, hitInfo);
                return hitLeft || hitRight;
            }
            bool isHit = false;
            for (const Primitive& p : node.primitives) {
                if (intersectRayWithTriangle(p.v0.position, p.v1.position, p.v2.position, ray, hitInfo)) {
                    describe(p, ray, hitInfo);
                    isHit = true;
                }
            }
            return isHit;
        }

        void describe(const Primitive& p, const Ray& ray, HitInfo& hitInfo) const
        {
            const glm::vec3 point = ray.origin + ray.t * ray.direction;
            const auto area = [&](const Vertex& a, const Vertex& b) {
                return glm::length(glm::cross(a.position - point, b.position - point));
            };
            glm::vec3& bc = hitInfo.barycentricCoord;
            bc = { area(p.v1, p.v2), area(p.v2, p.v0), area(p.v0, p.v1) };
            bc /= bc.x + bc.y + bc.z;
            hitInfo.material = m_material;
            hitInfo.texCoord = bc.x * p.v0.texCoord + bc.y * p.v1.texCoord + bc.z * p.v2.texCoord;
            hitInfo.normal = glm::normalize(bc.x * p.v0.normal + bc.y * p.v1.normal + bc.z * p.v2.normal);
            if (glm::dot(hitInfo.normal, ray.direction) > 0.0f)
                hitInfo.normal = -hitInfo.normal;
        }

        Material m_material; // of all
        std::vector<Primitive> m_primitives;
        std::unique_ptr<Node> m_root;
    };

    class NaiveRival : public ClosestOnlyRival {
    public:
        explicit NaiveRival(std::span<const Triangle> triangles)
            : m_tree(triangles)
        {
            name = "naive";
        }

    private:
        [[nodiscard]] bool intersect(Ray& ray) const override
        {
            HitInfo hitInfo;
            return m_tree.intersect(ray, hitInfo);
        }

        NaiveTree m_tree;
    };

}

void addNaive(std::span<const Triangle> triangles, Rivals& rivals)
{
    std::unique_ptr<Rival> rival;
    const double seconds = buildSecondsOf(rival, [&] { return std::make_unique<NaiveRival>(triangles); });
    rival->buildSeconds = seconds;
    rivals.push_back(std::move(rival));
}

}
