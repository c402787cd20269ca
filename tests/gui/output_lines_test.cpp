#include "gui/output_lines.h"
#include <catch2/catch.hpp>

using gui::OutputLines;

TEST_CASE("Text that comes in parts makes the same lines as text that comes at once", "[gui]")
{
    const std::string text = "first\n\nthird \x01 one\nfourth, not ended";
    OutputLines whole, parts;
    whole.append(text);
    for (const char c : text)
        parts.append({ &c, 1 });
    CHECK(whole.lines() == std::deque<std::string> { "first", "", "third \x01 one", "fourth, not ended" });
    CHECK(parts.lines() == whole.lines());
    whole.append(" yet\nfifth");
    CHECK(whole.lines().at(3) == "fourth, not ended yet");
    CHECK(whole.lines().back() == "fifth");
}

TEST_CASE("The last lines are kept", "[gui]")
{
    OutputLines printed;
    for (std::size_t i = 0; i < 3 * OutputLines::most; ++i)
        printed.append(std::to_string(i) + "\n");
    CHECK(printed.lines().size() == OutputLines::most);
    CHECK(printed.lines().front() == std::to_string(2 * OutputLines::most));
    CHECK(printed.lines().back() == std::to_string(3 * OutputLines::most - 1));
}

TEST_CASE("A line without end is broken, and nothing of it is lost", "[gui]")
{
    OutputLines printed;
    const std::string text = std::string(2 * OutputLines::longest, 'a') + "bc";
    printed.append(text + "\nnext");
    REQUIRE(printed.lines().size() == 4);
    CHECK(printed.lines()[0] + printed.lines()[1] + printed.lines()[2] == text);
    CHECK(printed.lines()[3] == "next");
    OutputLines full;
    full.append(std::string(OutputLines::longest, 'a') + "\nnext");
    CHECK(full.lines().size() == 2);
}

TEST_CASE("What is cleared begins anew", "[gui]")
{
    OutputLines printed;
    printed.append("half a line");
    printed.clear();
    CHECK(printed.lines().empty());
    printed.append("another");
    CHECK(printed.lines() == std::deque<std::string> { "another" });
}
