#include "grading/grade.h"
#include "files/digest.h"
#include "grading/check.h"
#include "grading/exam.h"
#include "grading/feature.h"
#include "grading/harmless.h"
#include "grading/observations.h"
#include "grading/row_store.h"
#include "grading/scene_folders.h"
#include "submission/submission.h"
#include "values/stopwatch.h"
#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <set>
#include <sstream>
#include <tbb/parallel_for.h>
#include <tbb/parallel_for_each.h>

namespace grading {
namespace {

    struct Verdict {
        Status status = Status::Passed;
        std::string message;
    };

    Verdict judgeFailure(const worker::Failure& failure)
    {
        switch (failure.kind) {
        case worker::Failure::Kind::Crashed:
            return { Status::Crashed, failure.what() };
        case worker::Failure::Kind::TimedOut:
            return { Status::TimedOut, failure.what() };
        case worker::Failure::Kind::Malformed:
            break;
        }
        return { Status::Wrong, failure.what() };
    }

    // A function with a changed signature is another function, and a stub stands in for it: says where it is.
    std::string withUndeclared(const NotAttempted& stub, const submission::Part& part)
    {
        std::istringstream lines(part.undeclared);
        std::string message = stub.what();
        for (std::string line; std::getline(lines, line);)
            for (const std::string& function : stub.functions)
                if (line.find(function + "(") != std::string::npos)
                    message += "\nis the signature another one? " + line;
        return message;
    }

    Verdict judge(const Check& check, Exam& exam, const submission::Part& part)
    {
        try {
            check.run(exam);
            return {};
        } catch (const Wrong& wrong) {
            return { Status::Wrong, wrong.what() };
        } catch (const NotAttempted& stub) {
            return { Status::NotAttempted, withUndeclared(stub, part) };
        } catch (const worker::Failure& failure) {
            return judgeFailure(failure);
        } catch (const worker::MalformedMessage& malformed) {
            return { Status::Wrong, malformed.what() };
        } catch (const worker::ProbeError& error) { // an exception that the submission threw
            return { Status::Crashed, fmt::format("threw an exception: {}", error.what()) };
        }
    }

    // What a row depends on beside the submission: the checks, the answers that are expected, and the scenes.
    std::string digestOfJudge(const ExpectedAnswers& expected)
    {
        return files::Digest().addFile("/proc/self/exe").add(expected.version()).add(digestOfScenes()).hex();
    }

    // One submission, built, and what its grading needs to know.
    struct Grading {
        const Assignment& assignment;
        submission::Submission submission;
        RowStore store;
        std::string judge; // a digest
    };

    // A feature, ready to be asked.
    class FeatureGrader {
    public:
        FeatureGrader(const Grading& grading, const Feature& feature)
            : m_grading(grading)
            , m_part(grading.submission.part(feature.file))
            , m_whyUntouched(grading.submission.whyUntouched(feature.file))
            , m_worker(grading.submission.featureWorker(feature.file))
        {
        }

        [[nodiscard]] Row grade(const Check& check)
        {
            if (m_part.state == submission::State::Refused)
                return toRow(check, { Status::Refused, m_part.message });
            if (!m_whyUntouched.empty())
                return toRow(check, { Status::NotAttempted, m_whyUntouched });
            const uint64_t seed = m_grading.assignment.secret.seedOf(m_worker.key, check.name);
            const std::string key = files::Digest()
                                        .add(m_worker.key)
                                        .add(m_grading.judge)
                                        .add(check.name)
                                        .add(std::to_string(seed))
                                        .hex();
            if (const auto known = m_grading.store.find(key))
                return *known;
            const Row row = ask(check, seed);
            m_grading.store.keep(key, row);
            return row;
        }

        [[nodiscard]] std::optional<Observation> observe(const Feature& feature, const KeptMessages& known) const
        {
            const std::string key = files::Digest().add(m_worker.key).add(m_grading.judge).add(feature.name).hex();
            return grading::observe(
                { feature.name, feature.file, m_worker.file, key }, *m_grading.assignment.expected, known);
        }

    private:
        [[nodiscard]] Row ask(const Check& check, uint64_t seed)
        {
            Exam exam { m_worker.file, *m_grading.assignment.expected, Random(seed), m_patience };
            Row row = toRow(check, judge(check, exam, m_part));
            row.pictures = exam.pictures;
            return row;
        }

        [[nodiscard]] static Row toRow(const Check& check, const Verdict& verdict)
        {
            const double score = verdict.status == Status::Passed ? check.points : 0.0;
            return { check.name, check.feature, score, check.points, verdict.status, harmless(verdict.message), nullptr,
                verdict.status == Status::Wrong ? check.usualCause : "" };
        }

        const Grading& m_grading;
        submission::Part m_part;
        std::string m_whyUntouched;
        submission::Program m_worker; // if it was built
        Patience m_patience;
    };

    struct Question {
        const Check& check;
        const Feature& feature;
        FeatureGrader& grader;
        Row row {};
        double seconds = 0.0;
    };

    std::vector<const Feature*> wantedFeatures(const std::string& only)
    {
        std::vector<const Feature*> wanted;
        for (const Feature& feature : gradedFeatures)
            if (only.empty() || feature.name == only)
                wanted.push_back(&feature);
        return wanted;
    }

    std::vector<std::string> filesOf(const std::vector<const Feature*>& features)
    {
        std::set<std::string> files;
        for (const Feature* feature : features)
            files.insert(feature->file);
        return { files.begin(), files.end() };
    }

    // Whether it answers at all, rightly or wrongly: what does not may make people wait once more.
    bool answers(const Feature& feature, const std::vector<Row>& rows)
    {
        return std::ranges::any_of(rows, [&](const Row& row) {
            return row.feature == feature.name && (row.status == Status::Passed || row.status == Status::Wrong);
        });
    }

    std::vector<Observation> observeAll(const Grading& grading, const std::vector<const Feature*>& features,
        const std::deque<FeatureGrader>& graders, const std::vector<Row>& rows)
    {
        constexpr std::size_t maxDrawings = 1000; // of seven a submission
        const KeptMessages known { grading.assignment.knownDrawings, maxDrawings };
        std::vector<std::optional<Observation>> found(features.size());
        tbb::parallel_for(std::size_t(0), features.size(), [&](std::size_t i) {
            if (answers(*features[i], rows))
                found[i] = graders[i].observe(*features[i], known);
        });
        std::vector<Observation> observations;
        for (std::optional<Observation>& observation : found)
            if (observation)
                observations.push_back(std::move(*observation));
        return observations;
    }

    // Side by side.
    void askAll(std::vector<Question>& questions, const std::function<void(const Row&)>& onRow)
    {
        tbb::parallel_for_each(questions, [&](Question& question) {
            const values::Stopwatch watch;
            question.row = question.grader.grade(question.check);
            question.seconds = watch.seconds();
            if (onRow)
                onRow(question.row);
        });
    }

    std::map<std::string, Times::OfFile> timesOfFiles(
        const submission::Submission& submission, const std::vector<Question>& questions)
    {
        std::map<std::string, Times::OfFile> files;
        for (const Question& question : questions) {
            const std::string& name = question.feature.file;
            Times::OfFile& file = files[name];
            file.compiling = submission.compileSeconds(name);
            file.linking = submission.featureWorker(name).seconds;
            file.asking += question.seconds;
        }
        return files;
    }

}

Outcome grade(const Assignment& assignment, const std::function<void(const Row&)>& onRow)
{
    const std::vector<const Feature*> wanted = wantedFeatures(assignment.onlyFeature);
    Grading grading { assignment, submission::Submission(assignment.submission), RowStore(assignment.knownRows),
        digestOfJudge(*assignment.expected) };
    Outcome outcome;
    outcome.times.building = values::secondsOf([&] { grading.submission.buildFeatureWorkers(filesOf(wanted)); });

    std::deque<FeatureGrader> features;
    std::vector<Question> questions;
    for (const Feature* feature : wanted) {
        FeatureGrader& grader = features.emplace_back(grading, *feature);
        for (const Check& check : Check::all())
            if (check.feature == feature->name)
                questions.push_back({ check, *feature, grader });
    }
    outcome.times.asking = values::secondsOf([&] { askAll(questions, onRow); });
    outcome.times.files = timesOfFiles(grading.submission, questions);
    for (Question& question : questions)
        outcome.rows.push_back(std::move(question.row));
    if (assignment.wantsObservations)
        outcome.times.drawing
            = values::secondsOf([&] { outcome.observations = observeAll(grading, wanted, features, outcome.rows); });
    return outcome;
}

}
