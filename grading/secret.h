#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace grading {

// What the random inputs of all checks follow from. Whoever does not know it cannot guess them.
class Secret {
public:
    // Everybody who knows the seed knows the inputs.
    explicit Secret(uint64_t seed);
    // The contents of a file. Throws files::Error when it cannot be read or has fewer than 16 bytes.
    explicit Secret(const std::filesystem::path& file);

    // The first 64 bits of HMAC-SHA-256(secret, submission, check) (RFC 2104).
    [[nodiscard]] uint64_t seedOf(std::string_view submission, std::string_view check) const;

private:
    std::string m_key;
};

}
