#pragma once
#include "grading/grade.h"

namespace grading {

// How a submission stands up to some thousands of the cases of ./raywork stress: a row for each file, of the feature
// "stress". A file, asked beside the reference's others, has its share of the points if no case failed. Seeds follow
// from the secret and the file, so that no case can be learnt by heart; a message has the line that repeats the first
// failure. Calls onRow after each file. Throws what grade() does.
[[nodiscard]] std::vector<Row> stressRows(
    const Assignment& assignment, double points, const std::function<void(const Row&)>& onRow);

[[nodiscard]] std::vector<std::string> namesOfStressRows();

}
