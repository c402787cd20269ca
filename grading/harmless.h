#pragma once
#include <string>

namespace grading {

// Words that a submission may have chosen: short, and nothing in them that a terminal or a reader's eye obeys.
[[nodiscard]] std::string harmless(const std::string& message);

}
