#include "grading/validate/change.h"
#include <cstdlib>
#include <fmt/format.h>
#include <map>

namespace grading {
namespace {

    using Alternatives = std::map<std::string_view, std::vector<std::string>>;

    // Of a comparison: the boundary moved, and the opposite.
    const Alternatives binaryOperators { { "<", { "<=", ">=" } }, { "<=", { "<", ">" } }, { ">", { ">=", "<=" } },
        { ">=", { ">", "<" } }, { "==", { "!=" } }, { "!=", { "==" } }, { "+", { "-" } }, { "-", { "+" } },
        { "*", { "/" } }, { "/", { "*" } }, { "+=", { "-=" } }, { "-=", { "+=" } }, { "*=", { "/=" } },
        { "/=", { "*=" } }, { "&&", { "||" } }, { "||", { "&&" } } };
    const Alternatives unaryOperators { { "++", { "--" } }, { "--", { "++" } } };
    const Alternatives words { { "min", { "max" } }, { "max", { "min" } }, { "true", { "false" } },
        { "false", { "true" } } };
    const Alternatives components { { "x", { "y" } }, { "y", { "x" } }, { "z", { "y" } } };

    std::vector<std::string> alternativesOf(const Alternatives& alternatives, std::string_view text)
    {
        const auto found = alternatives.find(text);
        return found == alternatives.end() ? std::vector<std::string> {} : found->second;
    }

    // 0 and 1 for each other; the negative; any other number raised by one.
    std::vector<std::string> otherNumbers(std::string_view number)
    {
        const std::string text { number };
        const double value = std::strtod(text.c_str(), nullptr);
        const std::string negative = fmt::format("(-{})", text);
        std::string flipped = text;
        flipped.front() = value == 0.0 ? '1' : '0';
        if (value == 0.0)
            return { flipped };
        if (value == 1.0)
            return { flipped, negative };
        return { fmt::format("({} + 1)", text), negative };
    }

    std::vector<std::string> alternativesOf(const Token& token, const Token* previous)
    {
        if (token.kind == TokenKind::Number)
            return otherNumbers(token.text);
        if (token.kind == TokenKind::Word)
            return alternativesOf(previous && previous->text == "." ? components : words, token.text);
        return alternativesOf(token.apart ? binaryOperators : unaryOperators, token.text);
    }

}

std::vector<Change> changesOfTokens(std::string_view source, const std::vector<Token>& tokens)
{
    std::vector<Change> changes;
    const Token* previous = nullptr;
    for (const Token& token : tokens) {
        const auto at = static_cast<std::size_t>(token.text.data() - source.data());
        for (const std::string& alternative : alternativesOf(token, previous))
            changes.push_back({ at, token.text.size(), alternative });
        previous = &token;
    }
    return changes;
}

}
