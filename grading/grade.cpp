#include "grading/grade.h"
#include "grading/check.h"
#include "grading/exam.h"
#include "grading/feature.h"
#include "grading/report.h"
#include "grading/row_store.h"
#include "grading/scene_folders.h"
#include "submission/digest.h"
#include "submission/submission.h"
#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <regex>
#include <set>
#include <sstream>
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

    // Words that a submission may have chosen: short, and nothing in them that a terminal or a reader's eye obeys.
    std::string harmless(const std::string& message)
    {
        constexpr std::size_t longest = 4000;
        std::string text = toUtf8(message.substr(0, longest));
        for (char& c : text)
            if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f)
                c = '?';
        // Control characters above ASCII, and those that turn the direction of writing.
        static const std::regex obeyed("\xc2[\x80-\x9f]|\xe2\x80[\x8e\x8f\xaa-\xae]|\xe2\x81[\xa6-\xa9]");
        return std::regex_replace(text, obeyed, "?");
    }

    // What a row depends on beside the submission: the checks, the answers that are expected, and the scenes.
    std::string digestOfJudge(const ExpectedAnswers& expected)
    {
        return submission::Digest().addFile("/proc/self/exe").add(expected.version()).add(digestOfScenes()).hex();
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
        {
            if (m_part.state != submission::State::Refused)
                m_worker = grading.submission.featureWorker(feature.file);
        }

        [[nodiscard]] Row grade(const Check& check)
        {
            if (m_part.state == submission::State::Refused)
                return toRow(check, { Status::Refused, m_part.message });
            const uint64_t seed = m_grading.assignment.secret.seedOf(m_worker.key, check.name);
            const std::string key = submission::Digest()
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
        submission::Program m_worker;
        Patience m_patience;
    };

    struct Question {
        const Check& check;
        FeatureGrader& feature;
        Row row;
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

}

std::vector<Row> grade(const Assignment& assignment, const std::function<void(const Row&)>& onRow)
{
    const std::vector<const Feature*> wanted = wantedFeatures(assignment.onlyFeature);
    Grading grading { assignment, submission::Submission(assignment.submission), RowStore(assignment.knownRows),
        digestOfJudge(*assignment.expected) };
    grading.submission.buildFeatureWorkers(filesOf(wanted));

    std::deque<FeatureGrader> features;
    std::vector<Question> questions;
    for (const Feature* feature : wanted) {
        FeatureGrader& grader = features.emplace_back(grading, *feature);
        for (const Check& check : Check::all())
            if (check.feature == feature->name)
                questions.push_back({ check, grader, {} });
    }
    tbb::parallel_for_each(questions, [&](Question& question) {
        question.row = question.feature.grade(question.check);
        if (onRow)
            onRow(question.row);
    });
    std::vector<Row> rows;
    for (Question& question : questions)
        rows.push_back(std::move(question.row));
    return rows;
}

}
