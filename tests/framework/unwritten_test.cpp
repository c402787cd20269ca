#include "not_written_yet.h"
#include "values/unwritten.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <thread>

TEST_CASE("A stub is listed once however often and on however many threads it is met, until taken", "[unwritten]")
{
    (void)values::takeUnwritten();
    static constexpr const char* first = "a stub of the tests";
    static constexpr const char* second = "another stub of the tests";
    const auto meet = [] {
        for (int i = 0; i < 1000; ++i) {
            notWrittenYet(first);
            notWrittenYet(second);
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back(meet);
    for (std::thread& thread : threads)
        thread.join();
    auto names = values::takeUnwritten();
    std::ranges::sort(names);
    CHECK(names == std::vector<std::string> { first, second });
    CHECK(values::takeUnwritten().empty());
    notWrittenYet(first);
    CHECK(values::takeUnwritten() == std::vector<std::string> { first });
}
