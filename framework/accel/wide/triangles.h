#pragma once
#include "accel/wide/box.h"
#include <ranges>

namespace accel::wide {

// Triangles by their index, wherever somebody else keeps them: a large scene has no room for an array of them beside
// all else.
class Triangles {
public:
    using Get = Triangle (*)(const void* source, uint32_t index);

    Triangles() = default; // none
    Triangles(const void* source, std::size_t size, Get get)
        : m_source(source)
        , m_size(static_cast<uint32_t>(size))
        , m_get(get)
    {
    }

    template <std::ranges::contiguous_range Array>
    requires std::same_as<std::ranges::range_value_t<Array>, Triangle> Triangles(const Array& array)
        : Triangles(std::ranges::data(array), std::ranges::size(array),
            [](const void* source, uint32_t index) { return static_cast<const Triangle*>(source)[index]; })
    {
    }

    [[nodiscard]] uint32_t size() const { return m_size; }
    [[nodiscard]] Triangle operator[](uint32_t index) const { return m_get(m_source, index); }

private:
    const void* m_source = nullptr;
    uint32_t m_size = 0;
    Get m_get = nullptr;
};

}
