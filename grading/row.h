#pragma once
#include <string>
#include <string_view>

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

// What became of one check.
struct Row {
    std::string name;
    std::string feature;
    double score = 0.0;
    double maxScore = 0.0;
    Status status = Status::NotAttempted;
    std::string message; // why it did not pass
};

}
