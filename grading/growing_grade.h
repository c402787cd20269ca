#pragma once
#include "grading/outputs.h"
#include "grading/row.h"
#include <chrono>
#include <filesystem>
#include <mutex>
#include <vector>

namespace grading {

// A grade while its checks are made. What there is of it is written after each, so that a grading that is cut off keeps
// that.
class GrowingGrade {
public:
    // Removes what an earlier grading wrote. Throws what writeJson() does.
    GrowingGrade(const std::filesystem::path& submission, const Outputs& outputs);

    // From any thread. Throws what writeJson() does.
    void add(const Row& row);

    // All rows, in the order of the checks, and what was drawn.
    [[nodiscard]] Grade complete(std::vector<Row> rows, std::vector<Observation> observations);

private:
    const Outputs& m_outputs;
    std::chrono::steady_clock::time_point m_start;
    std::mutex m_mutex; // of what follows
    Grade m_grade;
};

}
