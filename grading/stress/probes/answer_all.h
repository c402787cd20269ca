#pragma once
#include "worker/probe.h"
#include <vector>

// What a stress probe does: std::vector<Input> -> std::vector<Answer>, one after the other. Of a probe's input and
// answer both sides include the header.
namespace stress {

template <typename Input, typename Function> void answerAll(worker::Call& call, const Function& answer)
{
    const auto inputs = call.input.read<std::vector<Input>>();
    std::vector<decltype(answer(inputs.front()))> answers;
    answers.reserve(inputs.size());
    for (const Input& input : inputs)
        answers.push_back(answer(input));
    call.output << answers;
}

}
