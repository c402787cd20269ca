#pragma once
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace files {

// A file that is there and is no folder. Throws Error.
[[nodiscard]] std::ifstream openToRead(const std::filesystem::path& path);

// The whole file. Throws Error.
[[nodiscard]] std::string readText(const std::filesystem::path& path);

// Writes the whole file or, throwing Error, leaves what was there.
void writeText(const std::filesystem::path& path, std::string_view text);

// The extension in lower case, with its dot.
[[nodiscard]] std::string lowerExtension(const std::filesystem::path& path);

// Takes the next line off the text; "\n", "\r\n" and "\r" end one, as they do for tinyobj.
[[nodiscard]] std::string_view takeLine(std::string_view& text);

// Takes the next word off the line, empty if there is none; blanks and tabs separate words.
[[nodiscard]] std::string_view takeWord(std::string_view& line);

// The line without blanks and tabs around it.
[[nodiscard]] std::string_view trimmed(std::string_view line);

// The number that the whole word denotes; empty for anything else, also for what is not finite as a float.
[[nodiscard]] std::optional<float> parseNumber(std::string_view word);

// The first line, counted from 1, that matches; 0 if none does.
[[nodiscard]] int lineOf(std::string_view text, const std::function<bool(std::string_view)>& matches);

// One line on stderr, "file:line: warning: message".
void warn(const std::filesystem::path& path, int line, std::string_view message);

}
