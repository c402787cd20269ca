#include "grading/sealed_file.h"
#include "grading/hash.h"
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace grading {
namespace {

    [[noreturn]] void throwErrno(const std::filesystem::path& file)
    {
        throw std::system_error(errno, std::generic_category(), file.string());
    }

    bool writeAll(int descriptor, std::span<const std::byte> bytes)
    {
        while (!bytes.empty()) {
            const ssize_t written = write(descriptor, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR)
                continue;
            if (written <= 0)
                return false;
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        return true;
    }

}

void writeSealed(const std::filesystem::path& file, const worker::Message& message)
{
    std::string draft = file.string() + ".XXXXXX"; // a name that no other process has
    const int descriptor = mkstemp(draft.data());
    if (descriptor < 0)
        throwErrno(file);
    const Hash seal = hashOf(message.bytes());
    fchmod(descriptor, 0644); // for others to grade by
    const bool isWritten = writeAll(descriptor, seal) && writeAll(descriptor, message.bytes());
    close(descriptor);
    if (isWritten && std::rename(draft.c_str(), file.c_str()) == 0)
        return;
    const int error = errno;
    unlink(draft.c_str());
    errno = error;
    throwErrno(file);
}

std::optional<worker::Message> readSealed(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    const std::string text { std::istreambuf_iterator<char>(stream), {} };
    const auto bytes = std::as_bytes(std::span(text));
    Hash seal;
    if (!stream || bytes.size() < seal.size())
        return std::nullopt;
    const auto content = bytes.subspan(seal.size());
    std::ranges::copy(bytes.first(seal.size()), seal.begin());
    if (hashOf(content) != seal)
        return std::nullopt;
    return worker::Message({ content.begin(), content.end() });
}

}
