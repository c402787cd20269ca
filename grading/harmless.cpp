#include "grading/harmless.h"
#include "grading/report.h"
#include <regex>

namespace grading {

std::string harmless(const std::string& message)
{
    constexpr std::size_t longest = 4000;
    std::string text = toUtf8(message.substr(0, longest));
    for (char& c : text)
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f)
            c = '?';
    // Control characters above ASCII, and those that turn the direction of writing.
    static const std::regex obeyed("\xc2[\x80-\x9f]|\xe2\x80[\x8e\x8f\xaa-\xae]|\xe2\x81[\xa6-\xa9]");
    return std::regex_replace(text, obeyed, "?");
}

}
