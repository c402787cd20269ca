#pragma once
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace files {

// A name for what was added, in this order: equal names mean equal contents. BLAKE2b (RFC 7693) with 160 bits.
class Digest {
public:
    Digest();
    ~Digest();
    Digest(const Digest&) = delete;
    Digest& operator=(const Digest&) = delete;

    Digest& add(std::string_view text);
    Digest& add(std::span<const std::byte> bytes);
    // A file's contents. Throws Error when it cannot be read.
    Digest& addFile(const std::filesystem::path& path);
    // The names and contents of all files below a folder that end so, or of all.
    Digest& addFolder(const std::filesystem::path& folder, const std::string& extension = "");
    // In hexadecimal; ends the digest.
    [[nodiscard]] std::string hex();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}
