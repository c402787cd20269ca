#include "submission/log.h"
#include <algorithm>
#include <sstream>

namespace submission {

static constexpr int maxLines = 12;

static bool holdsAny(const std::string& line, std::initializer_list<const char*> words)
{
    return std::any_of(words.begin(), words.end(), [&](const char* word) { return line.find(word) != line.npos; });
}

std::string compilerErrors(const std::string& log)
{
    std::istringstream lines(log);
    std::string errors;
    int count = 0;
    for (std::string line; std::getline(lines, line) && count < maxLines;)
        if (count > 0 || holdsAny(line, { "error" }))
            errors += line + "\n", ++count;
    return errors.empty() ? "took more than a minute, four gigabytes, or 16 MB of output to compile\n" : errors;
}

std::string linkerErrors(const std::string& log)
{
    const std::string errors = linesWith({ "undefined reference", "multiple definition" }, log);
    if (!errors.empty())
        return errors;
    return log.empty() ? "took more than a minute or four gigabytes to link\n" : log.substr(0, 1000);
}

std::string linesWith(std::initializer_list<const char*> words, const std::string& log)
{
    std::istringstream lines(log);
    std::string found;
    int count = 0;
    for (std::string line; std::getline(lines, line) && count < maxLines;)
        if (holdsAny(line, words))
            found += line + "\n", ++count;
    return found;
}

}
