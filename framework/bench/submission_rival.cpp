#include "app/renderer.h"
#include "bench/rival.h"
#include "worker/traversal.h"
#include <cmath>

namespace bench {
namespace {

    // In a process of its own, whose clock it is measured by.
    class SubmissionRival : public Rival {
    public:
        SubmissionRival(const std::string& with, std::span<const Triangle> triangles)
            : m_worker(with)
        {
            name = with;
            buildSeconds = m_worker.ask<double>(
                "traversal.build", worker::TraversalTriangles(triangles.begin(), triangles.end()));
        }

        void load(std::span<const Ray> rays) override { m_rays.assign(rays.begin(), rays.end()); }

        double traceClosest() override
        {
            m_answer = m_worker.ask<worker::TraversalAnswer>("traversal.trace", m_rays);
            if (m_answer.distances.size() != m_rays.size())
                throw worker::Failure(worker::Failure::Kind::Malformed, "it answered for other rays");
            return m_answer.seconds;
        }

        double traceOccluded() override { return traceClosest(); } // the interface knows no better

        [[nodiscard]] float distance(std::size_t ray) const override { return m_answer.distances[ray]; }
        [[nodiscard]] bool isOccluded(std::size_t ray) const override { return std::isfinite(distance(ray)); }

    private:
        app::Renderer m_worker;
        worker::TraversalRays m_rays;
        worker::TraversalAnswer m_answer;
    };

}

void addSubmission(const std::string& with, std::span<const Triangle> triangles, Rivals& rivals)
{
    rivals.push_back(std::make_unique<SubmissionRival>(with, triangles));
}

}
