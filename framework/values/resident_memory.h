#pragma once
#include <cstddef>

namespace values {

// Bytes of memory that this process holds now. 0 where the system has no /proc that tells.
[[nodiscard]] std::size_t residentMemory();

// Bytes that a process may come to hold: what the machine has, or the limit on this one's address space if that is
// less.
[[nodiscard]] std::size_t availableMemory();

}
