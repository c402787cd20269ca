#include "worker/output.h"
#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <unistd.h>

using worker::Output;

namespace {

void print(const Output& output, const std::string& text)
{
    REQUIRE(write(output.descriptor(), text.data(), text.size()) == static_cast<ssize_t>(text.size()));
}

std::size_t bytesInMemory(const Output& output)
{
    struct stat status { };
    REQUIRE(fstat(output.descriptor(), &status) == 0);
    return static_cast<std::size_t>(status.st_blocks) * 512;
}

}

TEST_CASE("What is printed is taken once, in order", "[worker]")
{
    Output output;
    CHECK(output.take().empty());
    print(output, "one ");
    print(output, "two");
    CHECK(output.take() == "one two");
    CHECK(output.take().empty());
    print(output, " three");
    CHECK(output.take() == " three");
}

TEST_CASE("Of much that is printed the end is taken", "[worker]")
{
    Output output;
    print(output, std::string(3 * Output::atOnce, 'a') + "end");
    const std::string taken = output.take();
    CHECK(taken.size() == Output::atOnce);
    CHECK(taken.substr(taken.size() - 4) == "aend");
    print(output, "more");
    CHECK(output.take() == "more");
}

TEST_CASE("Printing for hours takes no memory where somebody takes what is printed", "[worker]")
{
    Output output;
    const std::string text(1 << 20, 'a');
    for (int i = 0; i < 100; ++i) {
        print(output, text);
        CHECK(output.take().size() == Output::atOnce);
        CHECK(bytesInMemory(output) <= 16 * Output::kept); // pages that hold what is kept, with room for larger ones
    }
}

TEST_CASE("The end of what was printed is known, also when it was taken", "[worker]")
{
    Output output;
    CHECK(output.last(10).empty());
    print(output, std::string(Output::atOnce, 'a') + "the end");
    CHECK(output.last(3) == "end");
    (void)output.take();
    CHECK(output.last(8) == "athe end");
}
