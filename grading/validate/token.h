#pragma once
#include <string_view>
#include <vector>

namespace grading {

enum class TokenKind { Word, Number, Symbol };

// A piece of C++ source that the compiler would see: no comments, strings, characters or preprocessor lines.
struct Token {
    TokenKind kind;
    std::string_view text; // of the source, which must live on
    bool apart; // blanks on both sides: of < > - * & this tells operators from brackets, signs and pointers
};

[[nodiscard]] std::vector<Token> tokensOf(std::string_view source);

}
