#include "files/kept_arrays.h"
#include "files/digest.h"
#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace files {
namespace {

    namespace fs = std::filesystem;

    // A file is a digest of its name and arrays, then the arrays, each after the number of its bytes.
    constexpr std::size_t digestLength = 40;

    std::string digestOf(const std::string& name, const std::vector<std::span<const std::byte>>& arrays)
    {
        Digest digest;
        digest.add(name);
        for (const std::span<const std::byte> array : arrays)
            digest.add(array);
        return digest.hex();
    }

    bool readBytes(std::istream& stream, std::span<std::byte> bytes)
    {
        return !!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }

    void writeBytes(std::ostream& stream, std::span<const std::byte> bytes)
    {
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }

    // An empty file that nobody else writes to; no path if there can be none.
    fs::path makeUnfinished(const fs::path& folder)
    {
        std::string path = folder / ".unfinished-XXXXXX";
        const int file = mkstemp(path.data());
        if (file < 0)
            return {};
        close(file);
        return path;
    }

}

bool KeptArrays::read(const std::string& name, const std::vector<Target>& targets) const
{
    const fs::path path = m_folder / name;
    std::error_code failed;
    std::uintmax_t left = fs::file_size(path, failed);
    std::ifstream stream(path, std::ios::binary);
    std::string digest(digestLength, '\0');
    if (failed || !readBytes(stream, std::as_writable_bytes(std::span(digest))))
        return false;
    std::vector<std::span<const std::byte>> arrays;
    for (const auto& [elementSize, resize] : targets) {
        uint64_t numBytes = 0;
        if (!readBytes(stream, std::as_writable_bytes(std::span(&numBytes, 1))))
            return false;
        if (numBytes > left || numBytes % elementSize != 0) // damaged: no memory is asked for
            return false;
        left -= numBytes;
        const std::span<std::byte> bytes = resize(numBytes / elementSize);
        if (bytes.size() != numBytes || !readBytes(stream, bytes))
            return false;
        arrays.emplace_back(bytes);
    }
    fs::last_write_time(path, fs::file_time_type::clock::now(), failed); // what is not used is the first to go
    return stream.peek() == std::ifstream::traits_type::eof() && digestOf(name, arrays) == digest;
}

void KeptArrays::write(const std::string& name, const std::vector<std::span<const std::byte>>& arrays) const
{
    const fs::path unfinished = makeUnfinished(m_folder);
    if (unfinished.empty())
        return;
    std::ofstream stream(unfinished, std::ios::binary);
    stream << digestOf(name, arrays);
    for (const std::span<const std::byte> array : arrays) {
        const uint64_t numBytes = array.size();
        writeBytes(stream, std::as_bytes(std::span(&numBytes, 1)));
        writeBytes(stream, array);
    }
    stream.close(); // a full disk may show only now
    std::error_code failed;
    if (stream)
        fs::rename(unfinished, m_folder / name, failed);
    if (!stream || failed)
        fs::remove(unfinished, failed);
}

}
