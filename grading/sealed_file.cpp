#include "grading/sealed_file.h"
#include "submission/digest.h"
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

    std::string sealOf(std::span<const std::byte> bytes)
    {
        return submission::Digest().add(bytes).hex();
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
    const std::string seal = sealOf(message.bytes());
    fchmod(descriptor, 0644); // for others to grade by
    const bool isWritten
        = writeAll(descriptor, std::as_bytes(std::span(seal))) && writeAll(descriptor, message.bytes());
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
    const std::size_t sealSize = sealOf({}).size();
    if (!stream || bytes.size() < sealSize)
        return std::nullopt;
    const auto content = bytes.subspan(sealSize);
    if (!text.starts_with(sealOf(content)))
        return std::nullopt;
    return worker::Message({ content.begin(), content.end() });
}

}
