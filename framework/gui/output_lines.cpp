#include "gui/output_lines.h"

namespace gui {

void OutputLines::append(std::string_view text)
{
    while (!text.empty()) {
        if (m_isComplete)
            beginLine();
        std::string& line = m_lines.back();
        const std::string_view rest = text.substr(0, std::min(text.find('\n'), longest - line.size()));
        line += rest;
        text.remove_prefix(rest.size());
        m_isComplete = !text.empty();
        if (text.starts_with('\n'))
            text.remove_prefix(1);
    }
}

void OutputLines::beginLine()
{
    m_lines.emplace_back();
    if (m_lines.size() > most)
        m_lines.pop_front();
}

void OutputLines::clear()
{
    m_lines.clear();
    m_isComplete = true;
}

}
