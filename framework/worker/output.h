#pragma once
#include "sandbox/file.h"
#include <string>

namespace worker {

// What a process prints, in memory until somebody takes it.
class Output {
public:
    static constexpr std::size_t atOnce = 64 << 10; // bytes that are taken, of much
    static constexpr std::size_t kept = 4 << 10; // bytes whose last are still there when they were taken

    // Throws std::system_error when there is no memory for it.
    Output();

    [[nodiscard]] int descriptor() const { return m_file; } // to print on

    // What is new since the last call, the end of it if that is much. What was taken takes no memory any longer. Not
    // for two threads at a time.
    [[nodiscard]] std::string take();

    // The end of all, taken or not.
    [[nodiscard]] std::string last(std::size_t count) const;

private:
    sandbox::File m_file;
    std::size_t m_taken = 0; // bytes
};

}
