#pragma once
#include <functional>

namespace grading {

// Runs work in a process of its own and returns its exit code. Whatever kills that process, a signal or a machine out
// of memory, is reported on stderr, and returned as killedCode. To be called before there are threads.
[[nodiscard]] int runSupervised(const std::function<int()>& work, int killedCode);

}
