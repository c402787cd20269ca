#include "gui/refinement.h"
#include "worker/message.h"
#include <algorithm>

namespace gui {

Refinement::Refinement(const Wanted& wanted)
    : m_number(wanted.number)
    , m_request { .view = wanted.view, .stride = worker::coarsestStride, .firstRow = 0, .seconds = 0.03 }
    , m_values(static_cast<std::size_t>(wanted.view.size.x * wanted.view.size.y))
{
}

void Refinement::add(const worker::Rows& rows)
{
    if (rows.end <= m_request.firstRow || rows.end > m_request.view.size.y)
        throw worker::MalformedMessage();
    auto value = rows.pixels.begin();
    for (int y = m_request.firstRow; y < rows.end; y += m_request.stride)
        for (int x = 0; x < m_request.view.size.x; x += m_request.stride)
            if (worker::isInPass(m_request.stride, x, y)) {
                if (value == rows.pixels.end())
                    throw worker::MalformedMessage();
                fill({ x, y }, *value++);
            }
    m_work += rows.work;
    m_needs = rows.needs;
    m_memory = rows.memory;
    m_request.firstRow = rows.end;
    if (rows.end == m_request.view.size.y) {
        m_request.firstRow = 0;
        m_request.stride /= 2;
    }
}

// A pixel stands for all that come after it in its square.
void Refinement::fill(glm::ivec2 pixel, const glm::vec3& value)
{
    const glm::ivec2 size = m_request.view.size;
    const glm::ivec2 end = glm::min(pixel + m_request.stride, size);
    for (int y = pixel.y; y < end.y; ++y) {
        const auto row = m_values.begin() + static_cast<std::ptrdiff_t>(y) * size.x;
        std::fill(row + pixel.x, row + end.x, value);
    }
}

Picture Refinement::picture() const
{
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - m_start;
    const debug::Quantity quantity = m_request.view.quantity;
    const debug::Range range = debug::rangeOf(quantity, m_values);
    return { .size = m_request.view.size,
        .pixels = debug::falseColors(quantity, m_values, range),
        .number = m_number,
        .isDone = isDone(),
        .seconds = elapsed.count(),
        .work = m_work,
        .needs = m_needs,
        .memory = m_memory,
        .quantity = quantity,
        .values = quantity == debug::Quantity::Color ? std::vector<glm::vec3>() : m_values,
        .range = range };
}

}
