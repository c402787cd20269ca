#pragma once
#include <cstddef>

namespace values {

// Bytes of memory that this process holds now. 0 where the system has no /proc that tells.
[[nodiscard]] std::size_t residentMemory();

}
