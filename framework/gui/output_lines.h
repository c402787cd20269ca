#pragma once
#include <deque>
#include <string>
#include <string_view>

namespace gui {

// The last lines of a text that goes on and on. One that is too long is broken.
class OutputLines {
public:
    static constexpr std::size_t most = 1000; // lines
    static constexpr std::size_t longest = 1000; // bytes of a line

    void append(std::string_view text); // from the middle of a line, it may be
    void clear();

    [[nodiscard]] const std::deque<std::string>& lines() const { return m_lines; }

private:
    void beginLine();

    std::deque<std::string> m_lines;
    bool m_isComplete = true; // the last one
};

}
