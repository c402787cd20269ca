#include "debug/recording.h"
#include "worker/message.h"
#include <catch2/catch.hpp>

// What another process sends may be anything.

using Value = std::variant<int, float>;

TEST_CASE("A variant arrives as the alternative that was sent", "[message]")
{
    worker::Message message;
    message << std::vector<Value> { 3, 2.5f };
    worker::Reader reader { message };
    CHECK(reader.read<std::vector<Value>>() == std::vector<Value> { 3, 2.5f });
}

TEST_CASE("An alternative that there is not is malformed", "[message]")
{
    worker::Message message;
    message << std::size_t(2) << 1.0f;
    worker::Reader reader { message };
    CHECK_THROWS_AS(reader.read<Value>(), worker::MalformedMessage);
}

TEST_CASE("A vector that is longer than its message is malformed, whatever it holds", "[message]")
{
    worker::Message message;
    message << (std::size_t(1) << 40) << 1 << 2;
    worker::Reader floats { message }, variants { message };
    CHECK_THROWS_AS(floats.read<std::vector<float>>(), worker::MalformedMessage);
    CHECK_THROWS_AS(variants.read<std::vector<Value>>(), worker::MalformedMessage);
}
