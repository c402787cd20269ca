#include "accel/wide/tree.h"
#include "bench/clock.h"
#include "bench/rival.h"

namespace bench {
namespace {

    class WideRival : public Rival {
    public:
        WideRival(std::shared_ptr<const accel::WideTree> tree, const accel::wide::Kernel& kernel)
            : m_tree(std::move(tree))
            , m_kernel(kernel)
        {
            name = kernel.name;
            numBytes = m_tree->numBytes();
        }

        void load(std::span<const Ray> rays) override
        {
            m_rays.assign(rays.begin(), rays.end());
            m_hits.assign(rays.size(), { std::numeric_limits<float>::infinity(), 0, 0.0f, 0.0f });
            m_occluded.assign(rays.size(), 0);
        }

        double traceClosest() override
        {
            return secondsOf([&] {
                for (std::size_t i = 0; i < m_rays.size(); ++i)
                    if (const auto hit = m_tree->closest(m_rays[i], m_kernel))
                        m_hits[i] = *hit;
            });
        }

        double traceOccluded() override
        {
            return secondsOf([&] {
                for (std::size_t i = 0; i < m_rays.size(); ++i)
                    m_occluded[i] = m_tree->occluded(m_rays[i], m_kernel);
            });
        }

        [[nodiscard]] float distance(std::size_t ray) const override { return m_hits[ray].t; }
        [[nodiscard]] bool isOccluded(std::size_t ray) const override { return m_occluded[ray]; }

    private:
        std::shared_ptr<const accel::WideTree> m_tree;
        const accel::wide::Kernel& m_kernel;
        std::vector<Ray> m_rays;
        std::vector<accel::WideTree::Hit> m_hits;
        std::vector<uint8_t> m_occluded;
    };

}

void addWide(std::span<const Triangle> triangles, Rivals& rivals)
{
    std::shared_ptr<const accel::WideTree> tree;
    const double seconds = buildSecondsOf(tree, [&] { return std::make_shared<accel::WideTree>(triangles); });
    for (const accel::wide::Kernel* kernel : accel::wide::kernels()) {
        rivals.push_back(std::make_unique<WideRival>(tree, *kernel));
        rivals.back()->buildSeconds = seconds;
    }
}

}
