#pragma once
#include "grading/stress/batch.h"
#include <memory>

// How to add a case: a probe in probes/<feature>.cpp (see probes/answer_all.h) calls the function under test; in
// <feature>.cpp a Question says how an answer is judged, and each Stress at namespace scope asks it of inputs of a
// kind:
//
//   const Question<Pair, float> sum { "sum", describe, judge };
//   const Stress huge("sum.huge", sum, randomly<Pair>(1'000'000, [](Random& random) { return Pair { ... }; }));
//   const Stress special("sum.special", sum, constructed<Pair>({ { "both zero", { 0.0f, 0.0f } }, ... }));
//
// An oracle calculates in more precision than the function, shares no code with it, and lets no NaN pass: write
// !(difference <= bound), with the bound's reason beside it. An input may also hold many cases, such as the rays
// through a scene: then the probe answers all of them, the judgement is on the worst, and casesEach says how many there
// are.
namespace stress {

// Inputs of one kind, and what must be true of the answers.
class Stress {
public:
    template <typename Input, typename Answer>
    Stress(std::string name_, const Question<Input, Answer>& question, const Inputs<Input>& inputs,
        std::size_t casesEach_ = 1)
        : name(std::move(name_))
        , feature(name.substr(0, name.find('.')))
        , probe(question.probe)
        , numInputs(inputs.count)
        , casesEach(casesEach_)
        , makeBatch([question, inputs](uint64_t seed, const Range& range) {
            return std::make_unique<const BatchOf<Input, Answer>>(question, inputs, seed, range);
        })
    {
        for (const auto& [called, input] : inputs.named)
            names.push_back(called);
        enroll();
    }

    std::string name; // feature.part.kind
    std::string feature; // the first part of the name
    std::string probe;
    std::size_t numInputs;
    std::size_t casesEach; // cases that an input holds
    std::vector<std::string> names; // of constructed inputs; empty where they are random
    std::function<std::unique_ptr<const Batch>(uint64_t seed, const Range&)> makeBatch;

    [[nodiscard]] bool isRandom() const { return names.empty(); }

    [[nodiscard]] static const std::vector<Stress>& all();

private:
    void enroll() const;
};

}
