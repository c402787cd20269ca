#pragma once
#include <string>

namespace report {

struct Content;

// What opens the report: what is missing in the texts and the figures, the grade and the stress summary, if there are
// any.
[[nodiscard]] std::string summaryOf(const Content& content);

}
