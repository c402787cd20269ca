#pragma once
#include <cstdlib>
#include <memory>
#include <new>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace accel::wide {

struct Free {
    void operator()(void* memory) const { std::free(memory); }
};

// Plain values, not initialised: what is not used takes no memory.
template <typename T> using LargeArray = std::unique_ptr<T[], Free>;

// In pages of two megabytes where the system has them, so that their addresses are found at once.
template <typename T> [[nodiscard]] LargeArray<T> makeLargeArray(std::size_t count)
{
    constexpr std::size_t page = std::size_t { 1 } << 21, line = 64;
    const std::size_t size = count * sizeof(T), alignment = size >= page ? page : line;
    const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, rounded);
    if (!memory)
        throw std::bad_alloc();
#ifdef __linux__
    if (alignment == page)
        madvise(memory, rounded, MADV_HUGEPAGE); // advice: all works without
#endif
    return LargeArray<T>(static_cast<T*>(memory));
}

}
