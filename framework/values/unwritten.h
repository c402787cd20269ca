#pragma once
#include <string>
#include <vector>

namespace values {

// The functions that called notWrittenYet since the last call of this.
[[nodiscard]] std::vector<std::string> takeUnwritten();

}
