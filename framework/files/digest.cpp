#include "files/digest.h"
#include "files/text.h"
#include <algorithm>
#include <sodium.h>
#include <vector>

namespace files {

struct Digest::State {
    crypto_generichash_state hash;
};

constexpr std::size_t numDigestBytes = 20;

Digest::Digest()
    : m_state(std::make_unique<State>())
{
    crypto_generichash_init(&m_state->hash, nullptr, 0, numDigestBytes);
}

Digest::~Digest() = default;

static void update(crypto_generichash_state& hash, std::string_view text)
{
    crypto_generichash_update(&hash, reinterpret_cast<const unsigned char*>(text.data()), text.size());
}

// With its length, so that "ab", "c" is not "a", "bc".
Digest& Digest::add(std::string_view text)
{
    update(m_state->hash, std::to_string(text.size()) + ":");
    update(m_state->hash, text);
    return *this;
}

Digest& Digest::add(std::span<const std::byte> bytes)
{
    return add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

Digest& Digest::addFile(const std::filesystem::path& path)
{
    return add(readText(path));
}

Digest& Digest::addFolder(const std::filesystem::path& folder, const std::string& extension)
{
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && (extension.empty() || entry.path().extension() == extension))
            found.push_back(entry.path());
    std::sort(found.begin(), found.end()); // a folder has no order
    for (const std::filesystem::path& path : found)
        add(path.lexically_relative(folder).generic_string()).addFile(path);
    return *this;
}

std::string Digest::hex()
{
    std::array<unsigned char, numDigestBytes> bytes {};
    crypto_generichash_final(&m_state->hash, bytes.data(), bytes.size());
    std::array<char, 2 * numDigestBytes + 1> text {};
    sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
    return text.data();
}

}
