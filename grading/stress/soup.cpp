#include "grading/stress/soup.h"
#include "grading/stress/oracle/crossing.h"
#include "grading/stress/text.h"

namespace stress {
namespace {

    std::string toText(const MetInSoup& answer)
    {
        const auto& [met, triangle, barycentric] = answer;
        return met.isHit ? fmt::format("triangle {} at t = {} with normal {} and weights {}", triangle, exactly(met.t),
                   exactly(met.normal), exactly(barycentric))
                         : "none";
    }

    // What the closest triangles of a ray may be.
    class Closest {
    public:
        Closest(const Soup& soup, const Ray& ray, double allowed)
            : m_ray(ray)
        {
            m_crossings.reserve(soup.triangles.size());
            for (const grading::Triangle& triangle : soup.triangles)
                m_crossings.emplace_back(triangle, ray, allowed);
            for (const Crossing& crossing : m_crossings)
                if (crossing.isSurelyMet(static_cast<double>(ray.t)))
                    m_atLeast = std::min(m_atLeast, crossing.t + crossing.error);
        }

        // Why the answer is wrong; empty if it is not.
        [[nodiscard]] std::string complaint(const MetInSoup& answer) const
        {
            const Met& met = answer.met;
            if (!met.isHit)
                return m_atLeast < infinity ? fmt::format("a hit at t = {}", m_atLeast)
                    : met.t == m_ray.t      ? ""
                                            : "t as it was";
            const auto number = static_cast<std::size_t>(std::max(answer.triangle, 0.0f));
            const double t = static_cast<double>(met.t), end = static_cast<double>(m_ray.t);
            if (!(t >= 0.0 && t <= end) || !(number < m_crossings.size()))
                return m_atLeast < infinity ? fmt::format("a hit at t = {}", m_atLeast) : "none";
            const Crossing& crossing = m_crossings[number];
            if (!crossing.mayBeMetAt(t) || crossing.isSurelyMissed(end))
                return fmt::format("this triangle at t = {} +- {:.2g}, or none", exactly(crossing.t), crossing.error);
            if (!(t <= m_atLeast))
                return fmt::format("a closer one, at t = {}", m_atLeast);
            return isNormal(met.normal, crossing, m_ray) ? "" : "a unit normal of this triangle that faces the ray";
        }

    private:
        static constexpr double infinity = std::numeric_limits<double>::infinity();

        const Ray& m_ray;
        std::vector<Crossing> m_crossings;
        double m_atLeast = infinity; // the closest hit is no farther, whatever is rounded
    };

    Judgement wrongRay(const Ray& ray, const MetInSoup& answer, const std::string& expected)
    {
        return wrong(toText(answer), fmt::format("for {}: {}", exactly(ray), expected));
    }

    bool isComplete(const Soup& soup, const std::vector<MetInSoup>& answers)
    {
        return answers.size() == soup.rays.size();
    }

}

std::string describe(const Soup& soup)
{
    std::string text = fmt::format("{} rays through {} triangles:", soup.rays.size(), soup.triangles.size());
    for (const auto& [v0, v1, v2] : soup.triangles)
        text += fmt::format("\n            {}, {}, {}", exactly(v0), exactly(v1), exactly(v2));
    return text;
}

Judgement judgeClosest(const Soup& soup, const std::vector<MetInSoup>& answers, double allowed)
{
    if (!isComplete(soup, answers))
        return wrong("fewer answers", "one for each ray");
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const std::string complaint = Closest(soup, soup.rays[i], allowed).complaint(answers[i]);
        if (!complaint.empty())
            return wrongRay(soup.rays[i], answers[i], complaint);
    }
    return right();
}

Judgement judgeHits(const Soup& soup, const std::vector<MetInSoup>& answers)
{
    if (!isComplete(soup, answers))
        return wrong("fewer answers", "one for each ray");
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (!answers[i].met.isHit || !std::isfinite(answers[i].met.t))
            return wrongRay(soup.rays[i], answers[i], "a hit: the triangles that share this edge or corner are closed");
    return right();
}

}
