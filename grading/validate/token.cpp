#include "grading/validate/token.h"
#include <algorithm>
#include <array>
#include <cctype>

namespace grading {
namespace {

    // Longest first. >> is not among them: it closes templates more often than it shifts.
    constexpr std::array<std::string_view, 20> longSymbols { "<=>", "...", "->", "::", "++", "--",
        "<=", ">=", "==", "!=", "&&", "||", "+=", "-=", "*=", "/=", "|=", "&=", "%=", "^=" };

    bool isSpace(char c)
    {
        return std::isspace(static_cast<unsigned char>(c)) != 0;
    }
    bool isDigit(char c)
    {
        return std::isdigit(static_cast<unsigned char>(c)) != 0;
    }
    bool isWord(char c)
    {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    }

    class Tokenizer {
    public:
        explicit Tokenizer(std::string_view source)
            : m_source(source)
        {
        }

        [[nodiscard]] std::vector<Token> run()
        {
            while (m_at < m_source.size())
                if (!skip())
                    take();
            return m_tokens;
        }

    private:
        [[nodiscard]] char peek(std::size_t ahead = 0) const
        {
            return m_at + ahead < m_source.size() ? m_source[m_at + ahead] : '\n';
        }

        // Passes what is no token; false if there is one.
        bool skip()
        {
            const std::string_view rest = m_source.substr(m_at);
            if (isSpace(peek()))
                ++m_at;
            else if (rest.starts_with("//"))
                skipTo("\n");
            else if (rest.starts_with("/*"))
                skipPast("*/");
            else if (peek() == '#') // as an operator it stands in preprocessor lines alone
                skipDirective();
            else if (peek() == '"' || peek() == '\'')
                skipQuoted(peek());
            else
                return false;
            return true;
        }

        void skipTo(std::string_view end) { m_at = std::min(m_source.find(end, m_at), m_source.size()); }

        void skipPast(std::string_view end)
        {
            skipTo(end);
            m_at = std::min(m_at + end.size(), m_source.size());
        }

        void skipDirective()
        {
            do
                skipPast("\n");
            while (m_at >= 2 && m_at < m_source.size() && m_source[m_at - 2] == '\\');
        }

        void skipQuoted(char quote)
        {
            for (++m_at; m_at < m_source.size() && peek() != quote; ++m_at)
                if (peek() == '\\')
                    ++m_at;
            m_at = std::min(m_at + 1, m_source.size());
        }

        void take()
        {
            if (isDigit(peek()) || (peek() == '.' && isDigit(peek(1))))
                push(TokenKind::Number, lengthOfNumber());
            else if (isWord(peek()))
                push(TokenKind::Word, lengthWhile([](char c) { return isWord(c); }));
            else
                push(TokenKind::Symbol, lengthOfSymbol());
        }

        template <typename Predicate> [[nodiscard]] std::size_t lengthWhile(const Predicate& belongs) const
        {
            std::size_t length = 0;
            while (m_at + length < m_source.size() && belongs(peek(length)))
                ++length;
            return length;
        }

        [[nodiscard]] std::size_t lengthOfNumber() const
        {
            char previous = '0';
            return lengthWhile([&](char c) {
                const bool sign = (c == '-' || c == '+') && (previous == 'e' || previous == 'E');
                previous = c;
                return isWord(c) || c == '.' || c == '\'' || sign;
            });
        }

        [[nodiscard]] std::size_t lengthOfSymbol() const
        {
            const auto* longest = std::ranges::find_if(
                longSymbols, [&](std::string_view symbol) { return m_source.substr(m_at).starts_with(symbol); });
            return longest == longSymbols.end() ? 1 : longest->size();
        }

        void push(TokenKind kind, std::size_t length)
        {
            const bool apart = m_at > 0 && isSpace(m_source[m_at - 1]) && isSpace(peek(length));
            m_tokens.push_back({ kind, m_source.substr(m_at, length), apart });
            m_at += length;
        }

        std::string_view m_source;
        std::size_t m_at = 0;
        std::vector<Token> m_tokens;
    };

}

std::vector<Token> tokensOf(std::string_view source)
{
    return Tokenizer(source).run();
}

}
