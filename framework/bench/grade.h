#pragma once
#include "bench/command.h"

namespace bench {

// Times gradings of a submission by the grader's program: of files that were never seen, of the same, of one that
// changed.
[[nodiscard]] Command declareGrade(CLI::App& cli);

}
