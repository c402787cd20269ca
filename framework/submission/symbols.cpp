#include "submission/symbols.h"
#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string_view>

namespace submission {

// A namespace stands before a name, or within it, as in "vtable for a::B" or "void a::f<int>()".
static bool mentions(std::string_view name, std::string_view space)
{
    for (std::size_t at = 0; (at = name.find(space, at)) != name.npos; ++at)
        if (at == 0 || std::string_view(" (<,*&").find(name[at - 1]) != std::string_view::npos)
            return true;
    return false;
}

static bool mentionsOneOf(std::string_view name, std::initializer_list<std::string_view> spaces)
{
    return std::any_of(spaces.begin(), spaces.end(), [&](std::string_view space) { return mentions(name, space); });
}

// The interface is global. A file may have namespaces of its own that happen to be called like ours, as long as it does
// not take from ours; none may stand in for a part of the worker.
static bool isForeign(bool isTaken, std::string_view name)
{
    return mentionsOneOf(name, { "worker::", "grading::" })
        || (isTaken && mentionsOneOf(name, { "accel::", "app::", "debug::", "files::", "shapes::", "values::" }));
}

// A line is "number: value size type bind visibility section name", where the section of what is taken is UND.
std::string firstForeignSymbol(const std::filesystem::path& list)
{
    std::ifstream lines(list);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string number, value, size, type, bind, visibility, section, name;
        words >> number >> value >> size >> type >> bind >> visibility >> section;
        std::getline(words >> std::ws, name);
        if (isForeign(section == "UND", name))
            return name;
    }
    return "";
}

}
