#include "grading/sealed_file.h"
#include "files/digest.h"
#include "grading/unfinished_file.h"
#include <fstream>
#include <span>
#include <string>

namespace grading {
namespace {

    std::string sealOf(std::span<const std::byte> bytes)
    {
        return files::Digest().add(bytes).hex();
    }

}

void writeSealed(const std::filesystem::path& file, const worker::Message& message)
{
    const auto bytes = message.bytes();
    UnfinishedFile unfinished { file };
    unfinished.write(sealOf(bytes));
    unfinished.write({ reinterpret_cast<const char*>(bytes.data()), bytes.size() });
    unfinished.finish();
}

std::optional<worker::Message> readSealed(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    const std::string text { std::istreambuf_iterator<char>(stream), {} };
    const auto bytes = std::as_bytes(std::span(text));
    const std::size_t sealSize = sealOf({}).size();
    if (!stream || bytes.size() < sealSize)
        return std::nullopt;
    const auto content = bytes.subspan(sealSize);
    if (!text.starts_with(sealOf(content)))
        return std::nullopt;
    return worker::Message({ content.begin(), content.end() });
}

}
