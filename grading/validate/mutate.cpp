#include "grading/validate/mutate.h"
#include "files/error.h"
#include "files/text.h"
#include "grading/feature.h"
#include "grading/validate/folder.h"
#include "grading/validate/survivors.h"
#include "submission/compile.h"
#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <map>
#include <stdexcept>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace grading {
namespace {

    namespace fs = std::filesystem;

    class FileMutation {
    public:
        FileMutation(std::string file, std::shared_ptr<ExpectedAnswers> expected, const OnProgress& onProgress)
            : m_file(std::move(file))
            , m_expected(std::move(expected))
            , m_onProgress(onProgress)
            , m_original(files::readText(referenceSource(m_file)))
        {
            for (Mutant& mutant : mutantsOf(m_original))
                m_mutants.push_back({ std::move(mutant), Fate::Survived });
        }

        [[nodiscard]] std::vector<GradedMutant> run(const fs::path& survivors)
        {
            explain(survivors);
            if (losesPoints(m_original))
                throw std::runtime_error("reference/" + m_file + ".cpp itself loses points");
            compile();
            gradeRest();
            return m_mutants;
        }

    private:
        void explain(const fs::path& list)
        {
            for (const Survivor& survivor : loadSurvivors(list)) {
                if (survivor.file != m_file)
                    continue;
                bool found = false;
                for (GradedMutant& graded : m_mutants) {
                    if (!survivor.is(graded.mutant))
                        continue;
                    graded.fate = Fate::Explained;
                    found = true;
                }
                if (!found) // the reference has changed since
                    throw files::Error(list, survivor.line,
                        "found no such mutant of reference/" + m_file
                            + ".cpp, expected both lines as --mutants shows them");
            }
        }

        // Does work(i) for every mutant whose fate is open, side by side.
        template <typename Work> void forOpen(const std::string& doing, const Work& work)
        {
            std::atomic<std::size_t> done = 0;
            tbb::parallel_for(std::size_t(0), m_mutants.size(), [&](std::size_t i) {
                m_onProgress(fmt::format("{}: {} mutant {} of {}", m_file, doing, ++done, m_mutants.size()));
                if (m_mutants[i].fate == Fate::Survived)
                    tbb::this_task_arena::isolate([&] { work(i); }); // a thread that waits begins no other mutant
            });
        }

        // Two mutants with the same object are one program, and those with the original's are no mutants.
        void compile()
        {
            m_objects.resize(m_mutants.size());
            forOpen("compiling", [&](std::size_t i) { m_objects[i] = objectOf(m_mutants[i].mutant.text); });
            const std::string original = objectOf(m_original);
            for (std::size_t i = 0; i < m_mutants.size(); ++i) {
                if (m_mutants[i].fate != Fate::Survived)
                    continue;
                if (m_objects[i].empty())
                    m_mutants[i].fate = Fate::Stillborn;
                else if (m_objects[i] == original)
                    m_mutants[i].fate = Fate::Same;
            }
        }

        // Empty if it does not compile.
        [[nodiscard]] std::string objectOf(const std::string& text) const
        {
            const submission::Object object = submission::compile(m_file, text);
            return object.part.state == submission::State::Built ? files::readText(object.file) : "";
        }

        void gradeRest()
        {
            std::map<std::string_view, std::size_t> firstOf; // by object
            for (std::size_t i = 0; i < m_mutants.size(); ++i)
                firstOf.emplace(m_objects[i], i);
            forOpen("grading", [&](std::size_t i) {
                if (firstOf.at(m_objects[i]) == i && losesPoints(m_mutants[i].mutant.text))
                    m_mutants[i].fate = Fate::Killed;
            });
            for (std::size_t i = 0; i < m_mutants.size(); ++i)
                if (m_mutants[i].fate == Fate::Survived)
                    m_mutants[i].fate = m_mutants[firstOf.at(m_objects[i])].fate;
        }

        [[nodiscard]] bool losesPoints(const std::string& text) const
        {
            Assignment assignment { folderOfThread(), m_expected, "" };
            fs::remove_all(assignment.submission);
            writeSource(assignment.submission / (m_file + ".cpp"), text);
            return std::ranges::any_of(gradedFeatures, [&](const Feature& feature) {
                assignment.onlyFeature = feature.name;
                return feature.file == m_file && losesPoints(assignment);
            });
        }

        // Most mutants lose points in the first checks: the rest is not waited for.
        [[nodiscard]] static bool losesPoints(const Assignment& assignment)
        {
            struct PointsLost { };
            try {
                (void)grade(assignment, [](const Row& row) {
                    if (row.score < row.maxScore)
                        throw PointsLost {};
                });
                return false;
            } catch (const PointsLost&) {
                return true;
            }
        }

        // What a thread writes is not in the way of another's. Outside of parallel loops the index is negative.
        [[nodiscard]] static fs::path folderOfThread()
        {
            const int thread = std::max(tbb::this_task_arena::current_thread_index(), 0);
            return validationFolder() / "mutants" / fmt::format("submission-{}", thread);
        }

        std::string m_file;
        std::shared_ptr<ExpectedAnswers> m_expected;
        const OnProgress& m_onProgress;
        std::string m_original;
        std::vector<GradedMutant> m_mutants;
        std::vector<std::string> m_objects; // empty: does not compile, or its fate was known before
    };

}

std::vector<GradedMutant> gradeMutants(const std::string& file, const std::shared_ptr<ExpectedAnswers>& expected,
    const fs::path& survivors, const OnProgress& onProgress)
{
    return FileMutation(file, expected, onProgress).run(survivors);
}

}
