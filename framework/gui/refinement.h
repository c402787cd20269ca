#pragma once
#include "gui/exchange.h"
#include <chrono>

namespace gui {

// A picture on its way from coarse to fine: which rows are to be asked for next, and what is known so far.
class Refinement {
public:
    explicit Refinement(const Wanted& wanted);

    [[nodiscard]] bool isDone() const { return m_request.stride == 0; }

    // The next rows, in a time that keeps a window's thread responsive.
    [[nodiscard]] const worker::RowsRequest& next() const { return m_request; }
    void add(const worker::Rows& rows);

    [[nodiscard]] Picture picture() const;

private:
    void fill(glm::ivec2 pixel, const glm::vec3& value);

    uint64_t m_number;
    worker::RowsRequest m_request;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    std::vector<glm::vec3> m_values;
    worker::Work m_work;
    std::vector<worker::ExplainedPart> m_needs;
    std::size_t m_memory = 0;
};

}
