#pragma once
#include <cstdlib>
#include <memory>
#include <new>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace accel::wide {

// Memory in pages of two megabytes where the system has them, so that their addresses are found at once; in lines of
// the cache where it is less than that. What nobody writes to costs nothing. To be freed by std::free.
[[nodiscard]] inline void* allocateLargePages(std::size_t size)
{
    constexpr std::size_t page = std::size_t { 1 } << 21, line = 64;
    const std::size_t alignment = size >= page ? page : line;
    const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, rounded);
    if (!memory)
        throw std::bad_alloc();
#ifdef __linux__
    if (alignment == page)
        madvise(memory, rounded, MADV_HUGEPAGE); // advice: all works without
#endif
    return memory;
}

// For containers.
template <typename T> struct LargePages {
    using value_type = T;
    static_assert(alignof(T) <= 64);

    LargePages() = default;
    template <typename U> explicit(false) LargePages(const LargePages<U>&) { }
    [[nodiscard]] static T* allocate(std::size_t count)
    {
        return static_cast<T*>(allocateLargePages(count * sizeof(T)));
    }
    static void deallocate(T* memory, std::size_t) { std::free(memory); }
    friend bool operator==(LargePages, LargePages) { return true; }
};

struct Free {
    void operator()(void* memory) const { std::free(memory); }
};

// Plain values, not initialised.
template <typename T> using LargeArray = std::unique_ptr<T[], Free>;

template <typename T> [[nodiscard]] LargeArray<T> makeLargeArray(std::size_t count)
{
    return LargeArray<T>(LargePages<T>::allocate(count));
}

}
