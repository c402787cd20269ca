#pragma once
#include "grading/validate/mutate.h"
#include "grading/validate/validate.h"
#include <string>
#include <vector>

namespace grading {

// How often the grader was wrong, each case by name, and bounds for the rates.
void printErrors(const GraderErrors& errors);

// The fates counted, and the mutants that survived.
void printMutants(const std::string& file, const std::vector<GradedMutant>& mutants);

}
