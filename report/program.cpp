#include "report/program.h"
#include <array>
#include <cstdio>

namespace report {

// A shell's word with any text in it.
static std::string wordOfShell(const std::string& text)
{
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

std::string runProgram(const std::vector<std::string>& words)
{
    std::string command;
    for (const std::string& word : words)
        command += wordOfShell(word) + " ";
    FILE* const pipe = popen((command + "2>&1 </dev/null").c_str(), "r");
    if (!pipe)
        throw ProgramFailed(words.front() + " cannot be started");
    std::string printed;
    std::array<char, 4096> buffer {};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        printed.append(buffer.data(), count);
    if (pclose(pipe) != 0)
        throw ProgramFailed(words.front() + " failed: " + printed);
    return printed;
}

}
