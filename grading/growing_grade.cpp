#include "grading/growing_grade.h"
#include "grading/report.h"
#include "sandbox/bubblewrap.h"

namespace grading {

// Of a folder, "a/b/" or "." too.
static std::string nameOf(const std::filesystem::path& folder)
{
    const std::filesystem::path whole = std::filesystem::weakly_canonical(folder);
    return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

GrowingGrade::GrowingGrade(const std::filesystem::path& submission, const Outputs& outputs)
    : m_outputs(outputs)
    , m_start(std::chrono::steady_clock::now())
    , m_grade { {}, nameOf(submission), 0.0, false, sandbox::whyNoBubblewrap() }
{
    // What an earlier grading left is not taken for this one's.
    for (const std::string& file : { outputs.junit, outputs.gradescope, outputs.html }) {
        std::error_code missing;
        if (!file.empty())
            std::filesystem::remove(file, missing);
    }
    if (!outputs.json.empty())
        writeJson(outputs.json, m_grade);
}

void GrowingGrade::add(const Row& row)
{
    const std::lock_guard lock(m_mutex);
    m_grade.rows.push_back(hide({ row }, m_outputs.hidden)[0]);
    if (!m_outputs.json.empty())
        writeJson(m_outputs.json, m_grade);
}

Grade GrowingGrade::complete(std::vector<Row> rows, std::vector<Observation> observations)
{
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - m_start;
    m_grade.rows = hide(std::move(rows), m_outputs.hidden);
    m_grade.observations = hide(std::move(observations), m_grade.rows);
    m_grade.seconds = elapsed.count();
    m_grade.isComplete = true;
    return m_grade;
}

}
