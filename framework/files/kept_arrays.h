#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace files {

// Arrays of plain values, or single ones, that took long to make, kept in a folder from one run to the next by a name
// that tells what they were made from. A file appears whole or not at all and is checked when it is read, so any number
// of processes may share a folder. That finds damage, not malice: whoever may write there is believed.
class KeptArrays {
public:
    explicit KeptArrays(std::filesystem::path folder)
        : m_folder(std::move(folder))
    {
    }

    // Whether they were there. If not, what the arrays hold is not said.
    template <typename... Arrays> [[nodiscard]] bool load(const std::string& name, Arrays&... arrays) const
    {
        return read(name, { targetOf(arrays)... });
    }

    // What cannot be kept, on a full disk, say, is not.
    template <typename... Arrays> void save(const std::string& name, const Arrays&... arrays) const
    {
        write(name, { std::as_bytes(spanOf(arrays))... });
    }

private:
    struct Target {
        std::size_t elementSize;
        std::function<std::span<std::byte>(std::size_t count)> resize;
    };

    template <typename T> static std::span<const T> spanOf(const T& value) { return { &value, 1 }; }
    template <typename T, typename A> static std::span<const T> spanOf(const std::vector<T, A>& array) { return array; }

    template <typename T> static Target targetOf(T& value)
    {
        return { sizeof(T),
            [&value](std::size_t count) { return std::as_writable_bytes(std::span(&value, count == 1 ? 1 : 0)); } };
    }

    template <typename T, typename A> static Target targetOf(std::vector<T, A>& array)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        return { sizeof(T), [&array](std::size_t count) {
                    array.resize(count);
                    return std::as_writable_bytes(std::span(array));
                } };
    }

    [[nodiscard]] bool read(const std::string& name, const std::vector<Target>& targets) const;
    void write(const std::string& name, const std::vector<std::span<const std::byte>>& arrays) const;

    std::filesystem::path m_folder;
};

}
