#pragma once
#include "worker/message.h"
#include <filesystem>
#include <optional>

namespace grading {

// A message in a file, behind its hash. Written beside it and moved into place, so that a reader finds either a whole
// one or none, whoever else writes it at the same time. Throws std::runtime_error when it cannot be written.
void writeSealed(const std::filesystem::path& file, const worker::Message& message);

// Nothing if there is no such file, or it is not whole.
[[nodiscard]] std::optional<worker::Message> readSealed(const std::filesystem::path& file);

}
