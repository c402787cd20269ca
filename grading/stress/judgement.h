#pragma once
#include <limits>
#include <string>

namespace stress {

// What an oracle says of one answer.
struct Judgement {
    bool isRight = true;
    // How far the answer is off, in units of the last place of what was expected, over the condition of the question:
    // how many roundings the function may be said to have made. 0 where an answer is right or wrong and nothing
    // between.
    double ulps = 0.0;
    std::string came {}, expected {}; // in words and numbers, of a wrong answer
};

[[nodiscard]] inline Judgement right(double ulps = 0.0)
{
    return { true, ulps };
}

[[nodiscard]] inline Judgement wrong(std::string came, std::string expected, double ulps = 0.0)
{
    return { false, ulps, std::move(came), std::move(expected) };
}

}
