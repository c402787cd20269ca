#pragma once
#include "grading/observation.h"
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace grading {

enum class Status { Passed, Wrong, NotAttempted, Crashed, TimedOut, Refused };

[[nodiscard]] constexpr std::string_view toText(Status status)
{
    switch (status) {
    case Status::Passed:
        return "passed";
    case Status::Wrong:
        return "wrong";
    case Status::NotAttempted:
        return "not attempted";
    case Status::Crashed:
        return "crashed";
    case Status::TimedOut:
        return "timed out";
    case Status::Refused:
        return "refused";
    }
    return "";
}

// The pictures that a check compared, for people to look at. Linear colours, row 0 at the bottom.
struct PicturePair {
    glm::ivec2 size { 0 };
    std::vector<glm::vec3> came;
    std::vector<glm::vec3> expected;
    glm::ivec2 worst { 0 }; // the pixel in the middle of the place that differs most
};

// What became of one check.
struct Row {
    std::string name;
    std::string feature;
    double score = 0.0;
    double maxScore = 0.0;
    Status status = Status::NotAttempted;
    std::string message; // why it did not pass
    std::shared_ptr<const PicturePair> pictures = nullptr; // if it compared any, passed or not
    std::string usualCause; // what to look at first, where the answer is wrong
    bool hidden = false; // from the student, who sees its name alone; its points count
};

// What became of a submission.
struct Grade {
    std::vector<Row> rows;
    std::string submission; // its name
    double seconds = 0.0; // what grading took
    bool isComplete = true; // no check is missing: the grade is final
    std::string notSandboxed; // why its code was not locked in; empty if it was
    std::vector<Observation> observations = {}; // of features, in their order
};

}
