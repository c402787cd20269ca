#pragma once
#include "gui/output_lines.h"

namespace gui {

// What the submission's code prints, the newest at the end, in a section that opens when the first comes.
class OutputPanel {
public:
    void add(std::string_view printed);
    void show(); // in the current ImGui window
    [[nodiscard]] const OutputLines& printed() const { return m_printed; }

private:
    void list();

    OutputLines m_printed;
    bool m_isFirst = false; // there was nothing before what came now
};

}
