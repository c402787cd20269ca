#include "app/render_goal.h"
#include <charconv>
#include <fmt/core.h>
#include <stdexcept>

namespace app {
namespace {

    // In (0, most].
    double parsePositive(const char* option, const std::string& text, double most)
    {
        double number = 0.0;
        const char* const end = text.data() + text.size();
        const auto [rest, failed] = std::from_chars(text.data(), end, number);
        if (failed != std::errc() || rest != end || !(number > 0.0 && number <= most))
            throw std::invalid_argument(
                fmt::format("{}: found '{}', expected a number above 0, at most {:g}", option, text, most));
        return number;
    }

}

adaptive::Goal parseGoal(const std::string& error, const std::string& time)
{
    constexpr double year = 365.0 * 24.0 * 3600.0;
    adaptive::Goal goal;
    if (!error.empty())
        goal.error = parsePositive("--error", error, 1.0);
    if (!time.empty())
        goal.seconds = parsePositive("--time", time, year);
    return goal;
}

}
