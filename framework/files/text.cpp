#include "files/text.h"
#include "files/error.h"
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cfloat>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace files {
namespace {

    constexpr std::string_view blanks = " \t";

}

std::ifstream openToRead(const std::filesystem::path& path)
{
    // A folder opens like a file and reads as an empty one.
    if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
        throw Error(path, "found a folder, expected a file");
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        throw Error(path, "cannot be read, expected an existing file");
    return stream;
}

std::string readText(const std::filesystem::path& path)
{
    std::ifstream stream = openToRead(path);
    std::error_code unknown; // of what is no regular file
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    constexpr std::size_t atOnce = 1 << 16;
    std::string text;
    text.reserve((unknown ? 0 : size) + atOnce);
    for (std::size_t got = atOnce; got == atOnce;) {
        const std::size_t before = text.size();
        text.resize(before + atOnce);
        stream.read(text.data() + before, atOnce);
        got = static_cast<std::size_t>(stream.gcount());
        text.resize(before + got);
    }
    return text;
}

void writeText(const std::filesystem::path& path, std::string_view text)
{
    const auto unfinished = path.parent_path() / (".unfinished-" + path.filename().string());
    std::ofstream stream(unfinished, std::ios::binary);
    stream << text;
    stream.close(); // a full disk may show only now
    std::error_code failed;
    if (stream)
        std::filesystem::rename(unfinished, path, failed);
    else
        failed = { errno, std::generic_category() };
    if (!failed)
        return;
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw Error(path, "cannot be written: " + failed.message());
}

std::string lowerExtension(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

std::string_view takeLine(std::string_view& text)
{
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : text.empty() ? 0 : 1);
    return line;
}

std::string_view takeWord(std::string_view& line)
{
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

std::string_view trimmed(std::string_view line)
{
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    return line.substr(0, line.find_last_not_of(blanks) + 1);
}

std::optional<float> parseNumber(std::string_view word)
{
    if (word.starts_with('+')) // from_chars knows no plus sign
        word.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc {} || end != word.data() + word.size() || !(std::abs(number) <= FLT_MAX))
        return {};
    return static_cast<float>(number);
}

int lineOf(std::string_view text, const std::function<bool(std::string_view)>& matches)
{
    for (int line = 1; !text.empty(); ++line)
        if (matches(takeLine(text)))
            return line;
    return 0;
}

void warn(const std::filesystem::path& path, int line, std::string_view message)
{
    std::fprintf(stderr, "%s:%d: warning: %.*s\n", path.string().c_str(), line, static_cast<int>(message.size()),
        message.data());
}

}
