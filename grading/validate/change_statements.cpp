#include "grading/validate/change.h"
#include <algorithm>
#include <array>

namespace grading {
namespace {

    using namespace std::string_view_literals;

    bool isOneOf(std::string_view text, std::initializer_list<std::string_view> texts)
    {
        return std::ranges::find(texts, text) != texts.end();
    }

    // Walks over the tokens and knows where a statement begins.
    class Statements {
    public:
        Statements(std::string_view source, const std::vector<Token>& tokens)
            : m_source(source)
            , m_tokens(tokens)
        {
        }

        [[nodiscard]] std::vector<Change> run()
        {
            for (m_at = 0; m_at < m_tokens.size(); ++m_at) {
                if (m_open.empty() && text(m_at) == "{")
                    addEarlyReturn();
                else if (beginsStatement())
                    addStatement();
                followBrackets();
            }
            return m_changes;
        }

    private:
        [[nodiscard]] std::string_view text(std::size_t i) const
        {
            return i < m_tokens.size() ? m_tokens[i].text : std::string_view {};
        }

        [[nodiscard]] std::size_t position(std::size_t i) const
        {
            return static_cast<std::size_t>(m_tokens[i].text.data() - m_source.data());
        }

        [[nodiscard]] std::size_t positionAfter(std::size_t i) const { return position(i) + text(i).size(); }

        void followBrackets()
        {
            if (isOneOf(text(m_at), { "(", "[", "{" })) {
                m_open.push_back(m_at);
            } else if (isOneOf(text(m_at), { ")", "]", "}" }) && !m_open.empty()) {
                m_closed = m_open.back();
                m_open.pop_back();
            }
            if (m_open.empty() && isOneOf(text(m_at), { ";", "}" }))
                m_declaration = m_at + 1;
        }

        // The token before is the end of if (...), for (...) or while (...).
        [[nodiscard]] bool followsControl() const
        {
            return text(m_at - 1) == ")" && m_closed > 0 && isOneOf(text(m_closed - 1), { "if", "for", "while" });
        }

        [[nodiscard]] bool beginsStatement() const
        {
            const bool inBlock = !m_open.empty() && text(m_open.back()) == "{";
            return inBlock && (isOneOf(text(m_at - 1), { ";", "{", "}", "else" }) || followsControl());
        }

        // The token that closes the bracket at `open`, or the last of all.
        [[nodiscard]] std::size_t matching(std::size_t open) const
        {
            int depth = 0;
            for (std::size_t i = open; i < m_tokens.size(); ++i) {
                depth += isOneOf(text(i), { "(", "[", "{" });
                depth -= isOneOf(text(i), { ")", "]", "}" });
                if (depth == 0)
                    return i;
            }
            return m_tokens.size() - 1;
        }

        // The semicolon at the end of what begins here; no token if a bracket ends it.
        [[nodiscard]] std::size_t semicolon() const
        {
            for (std::size_t i = m_at; i < m_tokens.size(); ++i) {
                if (text(i) == ";")
                    return i;
                if (isOneOf(text(i), { ")", "]", "}" }))
                    break;
                if (isOneOf(text(i), { "(", "[", "{" }))
                    i = matching(i);
            }
            return m_tokens.size();
        }

        // A type and a name: two words with nothing but *, & or template brackets between them.
        [[nodiscard]] bool isDeclaration(std::size_t begin) const
        {
            constexpr std::array keywords { "const"sv, "constexpr"sv, "auto"sv, "static"sv, "using"sv, "struct"sv };
            if (std::ranges::find(keywords, text(begin)) != keywords.end())
                return true;
            std::size_t i = begin;
            while (text(i + 1) == "::")
                i += 2;
            while (isOneOf(text(i + 1), { "*", "&", "<", ">", "," }) && !m_tokens[i + 1].apart)
                ++i;
            return i + 1 < m_tokens.size() && m_tokens[i + 1].kind == TokenKind::Word;
        }

        void addStatement()
        {
            if (text(m_at) == "if")
                return addNegation();
            // A function's last return cannot go: what happens then is undefined.
            const bool jumps
                = isOneOf(text(m_at), { "break", "continue" }) || (text(m_at) == "return" && followsControl());
            if (!jumps && (isOneOf(text(m_at), { "for", "while", "return", "else", ";", "}" }) || isDeclaration(m_at)))
                return;
            if (const std::size_t end = semicolon(); end < m_tokens.size())
                m_changes.push_back({ position(m_at), position(end) - position(m_at), "" });
        }

        void addNegation()
        {
            const std::size_t open = m_at + 1;
            if (isDeclaration(open + 1))
                return;
            const std::size_t begin = positionAfter(open);
            const std::size_t length = position(matching(open)) - begin;
            const std::string condition { m_source.substr(begin, length) };
            m_changes.push_back({ begin, length, "!(" + condition + ")" });
        }

        // At the brace that opens a body outside of all others: of a function if there is a parenthesis before it.
        void addEarlyReturn()
        {
            if (!isOneOf(text(m_at - 1), { ")", "const" }))
                return;
            const std::size_t begin = position(m_declaration);
            const std::size_t length = positionAfter(m_at) - begin;
            bool returnsNothing = false;
            for (std::size_t i = m_declaration; i < m_at && text(i) != "("; ++i)
                returnsNothing |= text(i) == "void";
            const std::string head { m_source.substr(begin, length) }; // so that the change shows whose body it is
            m_changes.push_back({ begin, length, head + (returnsNothing ? " return;" : " return {};") });
        }

        std::string_view m_source;
        const std::vector<Token>& m_tokens;
        std::size_t m_at = 0;
        std::size_t m_declaration = 0; // where the last one outside of all brackets begins
        std::size_t m_closed = 0; // the opening bracket of the pair that was closed last
        std::vector<std::size_t> m_open;
        std::vector<Change> m_changes;
    };

}

std::vector<Change> changesOfStatements(std::string_view source, const std::vector<Token>& tokens)
{
    return Statements(source, tokens).run();
}

}
