#pragma once
#include "grading/stress/judgement.h"
#include "grading/stress/random.h"
#include "worker/message.h"
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace stress {

// What is asked of a worker, and who judges.
template <typename Input, typename Answer> struct Question {
    std::string probe; // std::vector<Input> -> std::vector<Answer>
    std::string (*describe)(const Input&); // exactly: see text.h
    Judgement (*judge)(const Input&, const Answer&);
};

// Inputs by number.
template <typename Input> struct Inputs {
    std::size_t count; // of random ones, unless somebody wants more or fewer
    std::function<Input(Random&)> generate; // empty where they are constructed
    std::vector<std::pair<std::string, Input>> named; // by hand, with what each is called

    // The same for the same seed, whatever was made before.
    [[nodiscard]] Input at(uint64_t seed, std::size_t i) const
    {
        Random random { SplitMix(seed + i)() };
        return generate ? generate(random) : named.at(i).second;
    }
};

template <typename Input> [[nodiscard]] Inputs<Input> randomly(std::size_t count, Input (*generate)(Random&))
{
    return { count, generate, {} };
}

template <typename Input> [[nodiscard]] Inputs<Input> constructed(std::vector<std::pair<std::string, Input>> named)
{
    const std::size_t count = named.size();
    return { count, {}, std::move(named) };
}

// Which inputs.
struct Range {
    std::size_t first = 0, count = 0;
};

// Some of the inputs of one kind: a message to a worker, and the judgement on what it answers.
class Batch {
public:
    using OnJudged = std::function<void(std::size_t, Judgement)>;

    Batch() = default;
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;
    virtual ~Batch() = default;

    [[nodiscard]] virtual worker::Message question() const = 0;
    // Calls onJudged(input of the batch, judgement) for each. Throws worker::MalformedMessage.
    virtual void judge(const worker::Message& answer, const OnJudged& onJudged) const = 0;
    [[nodiscard]] virtual std::string describe(std::size_t input) const = 0;
};

template <typename Input, typename Answer> class BatchOf : public Batch {
public:
    BatchOf(const Question<Input, Answer>& question, const Inputs<Input>& inputs, uint64_t seed, const Range& range)
        : m_question(question)
    {
        m_inputs.reserve(range.count);
        for (std::size_t i = 0; i < range.count; ++i)
            m_inputs.push_back(inputs.at(seed, range.first + i));
    }

    [[nodiscard]] worker::Message question() const override
    {
        worker::Message message;
        message << m_inputs;
        return message;
    }

    void judge(const worker::Message& answer, const OnJudged& onJudged) const override
    {
        const auto answers = worker::Reader(answer).read<std::vector<Answer>>();
        if (answers.size() != m_inputs.size())
            throw worker::MalformedMessage();
        for (std::size_t i = 0; i < answers.size(); ++i)
            onJudged(i, m_question.judge(m_inputs[i], answers[i]));
    }

    [[nodiscard]] std::string describe(std::size_t input) const override
    {
        return m_question.describe(m_inputs[input]);
    }

private:
    Question<Input, Answer> m_question;
    std::vector<Input> m_inputs;
};

}
