#include "grading/validate/mutant.h"
#include "files/text.h"
#include "grading/validate/change.h"
#include <algorithm>

namespace grading {
namespace {

    // The code of the lines in one, without comments at their ends.
    std::string inOneLine(std::string_view text)
    {
        std::string result;
        while (!text.empty()) {
            std::string_view line = files::takeLine(text);
            line = line.substr(0, line.find("//"));
            for (std::string_view word = files::takeWord(line); !word.empty(); word = files::takeWord(line))
                result.append(result.empty() ? "" : " ").append(word);
        }
        return result;
    }

    Mutant applied(const std::string& source, const Change& change)
    {
        const std::size_t begin = change.at == 0 ? 0 : source.rfind('\n', change.at - 1) + 1; // npos + 1 is 0
        const std::size_t end = std::min(source.find('\n', change.at + change.length), source.size());
        std::string text = source;
        text.replace(change.at, change.length, change.replacement);
        const std::size_t length = end - begin;
        return { static_cast<int>(std::count(source.begin(), source.begin() + static_cast<long>(change.at), '\n')) + 1,
            inOneLine(std::string_view(source).substr(begin, length)),
            inOneLine(std::string_view(text).substr(begin, length - change.length + change.replacement.size())), text };
    }

}

std::vector<Mutant> mutantsOf(const std::string& source)
{
    const std::vector<Token> tokens = tokensOf(source);
    std::vector<Change> changes = changesOfTokens(source, tokens);
    std::ranges::copy(changesOfStatements(source, tokens), std::back_inserter(changes));
    std::ranges::stable_sort(changes, {}, &Change::at);
    std::vector<Mutant> mutants;
    for (const Change& change : changes)
        mutants.push_back(applied(source, change));
    return mutants;
}

}
