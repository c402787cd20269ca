#pragma once
#include "worker/message.h"
#include <string>

namespace grading {

// What the reference answers, wherever that comes from. A question depends neither on the submission nor on the seed of
// its random inputs, so that its answer can be kept.
class ExpectedAnswers {
public:
    virtual ~ExpectedAnswers() = default;

    // From any thread. Throws std::runtime_error when there is no answer: then there is nothing to judge by.
    [[nodiscard]] virtual worker::Message answer(const std::string& probe, const worker::Message& input) = 0;

    // Changes with whatever answers may change with.
    [[nodiscard]] virtual std::string version() const = 0;

    // Whether to ask also what only other submissions make necessary.
    [[nodiscard]] virtual bool wantsAll() const { return false; }
};

// Identifies a question and the scene files that it may name.
[[nodiscard]] std::string keyOf(const std::string& probe, const worker::Message& input);

}
