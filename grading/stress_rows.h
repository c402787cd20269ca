#pragma once
#include "grading/grade.h"

namespace grading {

// How a submission stands up to a few thousand of the cases of ./raywork stress: a row for each part of the interface
// that is the submission's, of the feature "stress". A part has its share of the points if no case failed. Seeds follow
// from the secret and the submission, so that no case can be learnt by heart; a message has the line that repeats the
// first failure. Calls onRow after each part. Throws what grade() does.
[[nodiscard]] std::vector<Row> stressRows(
    const Assignment& assignment, double points, const std::function<void(const Row&)>& onRow);

[[nodiscard]] std::vector<std::string> namesOfStressRows();

}
