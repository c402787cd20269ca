#include "grading/grade.h"
#include "grading/check.h"
#include "grading/exam.h"
#include "grading/feature.h"
#include "submission/submission.h"
#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <sstream>
#include <tbb/parallel_for.h>

namespace grading {
namespace {

    struct Verdict {
        Status status = Status::Passed;
        std::string message;
        std::shared_ptr<const PicturePair> pictures = nullptr;
    };

    std::string withCause(const std::string& what, const Check& check)
    {
        return fmt::format("{} (usually: {})", what, check.usualCause);
    }

    Verdict judgeFailure(const worker::Failure& failure, const Check& check)
    {
        switch (failure.kind) {
        case worker::Failure::Kind::Crashed:
            return { Status::Crashed, failure.what() };
        case worker::Failure::Kind::TimedOut:
            return { Status::TimedOut, failure.what() };
        case worker::Failure::Kind::Malformed:
            break;
        }
        return { Status::Wrong, withCause(failure.what(), check) };
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
            return { Status::Wrong, withCause(wrong.what(), check) };
        } catch (const NotAttempted& stub) {
            return { Status::NotAttempted, withUndeclared(stub, part) };
        } catch (const worker::Failure& failure) {
            return judgeFailure(failure, check);
        } catch (const worker::MalformedMessage& malformed) {
            return { Status::Wrong, withCause(malformed.what(), check) };
        } catch (const worker::ProbeError& error) { // an exception that the submission threw
            return { Status::Crashed, fmt::format("threw an exception: {}", error.what()) };
        }
    }

    // Words that a submission may have chosen: short, and nothing in them that a terminal obeys.
    std::string harmless(std::string message)
    {
        constexpr std::size_t longest = 4000;
        message.resize(std::min(message.size(), longest));
        for (char& c : message)
            if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
                c = '?';
        return message;
    }

    // A feature's checks, one after the other.
    class FeatureGrader {
    public:
        FeatureGrader(const Assignment& assignment, const submission::Submission& submission, const Feature& feature)
            : m_assignment(assignment)
            , m_submission(submission)
            , m_feature(feature)
            , m_part(submission.parts().at(feature.file))
        {
        }

        [[nodiscard]] Row grade(const Check& check)
        {
            const Verdict verdict = reach(check);
            const double score = verdict.status == Status::Passed ? check.points : 0.0;
            return { check.name, check.feature, score, check.points, verdict.status, harmless(verdict.message),
                verdict.pictures };
        }

    private:
        [[nodiscard]] Verdict reach(const Check& check)
        {
            if (m_part.state == submission::State::Refused)
                return { Status::Refused, m_part.message };
            Exam exam { m_submission.featureWorker(m_feature.file), *m_assignment.expected,
                Random(m_assignment.seed, check.name), m_slowProbes };
            Verdict verdict = judge(check, exam, m_part);
            verdict.pictures = exam.pictures;
            return verdict;
        }

        const Assignment& m_assignment;
        const submission::Submission& m_submission;
        const Feature& m_feature;
        submission::Part m_part;
        SlowProbes m_slowProbes;
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
    submission::Submission submission { assignment.submission };
    submission.buildFeatureWorkers(filesOf(wanted));

    std::vector<std::vector<Row>> rows(wanted.size());
    tbb::parallel_for(std::size_t(0), wanted.size(), [&](std::size_t i) {
        FeatureGrader grader { assignment, submission, *wanted[i] };
        for (const Check& check : Check::all()) {
            if (check.feature != wanted[i]->name)
                continue;
            rows[i].push_back(grader.grade(check));
            if (onRow)
                onRow(rows[i].back());
        }
    });
    std::vector<Row> all;
    for (const std::vector<Row>& ofFeature : rows)
        all.insert(all.end(), ofFeature.begin(), ofFeature.end());
    return all;
}

}
