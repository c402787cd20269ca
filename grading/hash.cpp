#include "grading/hash.h"
#include "worker/message.h"
#include <fstream>
#include <map>
#include <sodium/crypto_generichash.h>
#include <stdexcept>
#include <vector>

namespace grading {

Hash hashOf(std::span<const std::byte> bytes)
{
    Hash hash;
    static_assert(sizeof(Hash) == crypto_generichash_BYTES);
    crypto_generichash(reinterpret_cast<unsigned char*>(hash.data()), hash.size(),
        reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), nullptr, 0);
    return hash;
}

Hash hashOfFile(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    const std::string text { std::istreambuf_iterator<char>(stream), {} };
    if (!stream)
        throw std::runtime_error(file.string() + ": cannot be read");
    return hashOf(std::as_bytes(std::span(text)));
}

Hash hashOfFolder(const std::filesystem::path& folder)
{
    std::map<std::string, Hash> files; // in an order that does not depend on the file system
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.emplace(entry.path().lexically_relative(folder).generic_string(), hashOfFile(entry.path()));
    worker::Message all;
    for (const auto& [name, hash] : files)
        all << name << hash;
    return hashOf(all.bytes());
}

std::string toHex(const Hash& hash)
{
    std::string hex;
    for (const std::byte byte : hash)
        for (const unsigned digit :
            { std::to_integer<unsigned>(byte >> 4), std::to_integer<unsigned>(byte & std::byte(15)) })
            hex += "0123456789abcdef"[digit];
    return hex;
}

}
