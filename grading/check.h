#pragma once
#include <string>
#include <vector>

namespace grading {

class Exam;

// A question with points. Define one at namespace scope to register it; a feature's checks run in the order defined.
class Check {
public:
    using Function = void (*)(Exam&);

    // name: feature.part.case; usualCause: what a student should look at first when it fails.
    Check(std::string name, double points, std::string usualCause, Function run);

    std::string name;
    std::string feature; // the first part of the name
    double points;
    std::string usualCause;
    Function run; // throws what exam.h lists where the answer is not right

    [[nodiscard]] static const std::vector<Check>& all();
};

}
