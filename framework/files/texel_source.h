#pragma once
#include <cstdint>
#include <functional>
#include <mutex>
#include <vector>

namespace files {

// Where an image's texels come from when they are first looked at. Throws what goes wrong, to whoever looks.
struct TexelSource {
    std::function<std::vector<uint8_t>()> read;
    std::mutex mutex; // one thread reads, the others wait for it
};

}
