#include "grading/validate/validate.h"
#include "grading/feature.h"
#include "grading/validate/folder.h"
#include <fmt/format.h>

namespace grading {
namespace {

    class Validation {
    public:
        Validation(uint64_t firstSeed, std::shared_ptr<ExpectedAnswers> expected, const OnProgress& onProgress)
            : m_firstSeed(firstSeed)
            , m_expected(std::move(expected))
            , m_onProgress(onProgress)
        {
        }

        [[nodiscard]] GraderErrors run(const Bank& bank, std::size_t acceptedGradings)
        {
            const std::size_t accepted = bank.accepted.size();
            const std::size_t seeds = accepted == 0 ? 0 : (acceptedGradings + accepted - 1) / accepted;
            m_total = bank.wrong.size() + accepted * seeds;
            m_errors.wrongSolutions = bank.wrong.size();
            m_errors.acceptedSolutions = accepted;
            for (const Solution& solution : bank.wrong)
                gradeWrong(solution);
            for (const Solution& solution : bank.accepted)
                for (std::size_t i = 0; i < seeds; ++i)
                    gradeAccepted(solution, m_firstSeed + i);
            return m_errors;
        }

    private:
        [[nodiscard]] std::vector<Row> gradeOnce(const Solution& solution, uint64_t seed)
        {
            m_onProgress(fmt::format("{} of {}: {}", ++m_done, m_total, solution.title()));
            writeChangedReference(m_folder, solution.file, solution.text);
            return grade({ m_folder, m_expected, "", Secret(seed) });
        }

        void gradeWrong(const Solution& solution)
        {
            std::set<std::string> failed;
            for (const Row& row : gradeOnce(solution, m_firstSeed)) {
                if (row.score >= row.maxScore)
                    continue;
                failed.insert(row.feature);
                if (!solution.costs.contains(row.feature))
                    m_errors.takenElsewhere.push_back({ solution.title(), m_firstSeed, row.name, row.message });
            }
            std::string missed;
            for (const Feature& feature : gradedFeatures) {
                const bool isWrong = solution.costs.contains(feature.name);
                if (isWrong && !failed.contains(feature.name))
                    missed += (missed.empty() ? "" : ", ") + feature.name;
                m_errors.untouchedFeatures += !isWrong;
                m_errors.wronglyTouchedFeatures += !isWrong && failed.contains(feature.name);
            }
            if (!missed.empty())
                m_errors.falseAccepts.push_back(fmt::format("{} (all points for {})", solution.title(), missed));
        }

        void gradeAccepted(const Solution& solution, uint64_t seed)
        {
            const std::size_t before = m_errors.falseRejects.size();
            for (const Row& row : gradeOnce(solution, seed))
                if (row.score < row.maxScore)
                    m_errors.falseRejects.push_back({ solution.title(), seed, row.name, row.message });
            ++m_errors.acceptedGradings;
            m_errors.falselyRejectedGradings += m_errors.falseRejects.size() > before;
        }

        uint64_t m_firstSeed;
        std::shared_ptr<ExpectedAnswers> m_expected;
        std::filesystem::path m_folder = validationFolder() / "solution";
        const OnProgress& m_onProgress;
        std::size_t m_done = 0, m_total = 0;
        GraderErrors m_errors;
    };

}

GraderErrors validate(const Bank& bank, std::size_t acceptedGradings, uint64_t firstSeed,
    const std::shared_ptr<ExpectedAnswers>& expected, const OnProgress& onProgress)
{
    return Validation(firstSeed, expected, onProgress).run(bank, acceptedGradings);
}

}
