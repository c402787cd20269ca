#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace worker {

// What a message holds did not fit what was read from it.
class MalformedMessage : public std::runtime_error {
public:
    MalformedMessage()
        : std::runtime_error("a message ended early")
    {
    }
};

// Values as bytes, for another process on this machine. Anything that is plain data can be written as it is; types
// with pointers in them have overloads of their own.
class Message {
public:
    Message() = default;
    explicit Message(std::vector<std::byte> bytes)
        : m_bytes(std::move(bytes))
    {
    }

    [[nodiscard]] std::span<const std::byte> bytes() const { return m_bytes; }

    template <typename T>
    requires std::is_trivially_copyable_v<T>
    void append(const T* values, std::size_t count) { appendBytes(values, count * sizeof(T)); }

private:
    void appendBytes(const void* bytes, std::size_t count);

    std::vector<std::byte> m_bytes;
};

// Takes a message's values in the order in which they were written. Throws MalformedMessage past its end.
class Reader {
public:
    explicit Reader(const Message& message)
        : m_rest(message.bytes())
    {
    }

    [[nodiscard]] std::span<const std::byte> take(std::size_t count)
    {
        if (count > m_rest.size())
            throw MalformedMessage();
        const auto taken = m_rest.first(count);
        m_rest = m_rest.subspan(count);
        return taken;
    }

    [[nodiscard]] std::span<const std::byte> rest() const { return m_rest; }

    template <typename T> [[nodiscard]] T read()
    {
        T value;
        *this >> value;
        return value;
    }

private:
    std::span<const std::byte> m_rest;
};

template <typename T> inline constexpr bool isVariant = false;
template <typename... Ts> inline constexpr bool isVariant<std::variant<Ts...>> = true;

// Pointers mean nothing elsewhere. Other types that are no plain data are ruled out by their overloads' absence.
template <typename T>
concept Plain = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> && !std::is_same_v<T, bool> && !isVariant<T>;

template <Plain T> Message& operator<<(Message& message, const T& value)
{
    message.append(&value, 1);
    return message;
}

template <Plain T> Reader& operator>>(Reader& reader, T& value)
{
    std::memcpy(static_cast<void*>(&value), reader.take(sizeof(T)).data(), sizeof(T));
    return reader;
}

// Another process may send any byte for a bool.
inline Message& operator<<(Message& message, bool value)
{
    return message << static_cast<unsigned char>(value);
}

inline Reader& operator>>(Reader& reader, bool& value)
{
    value = reader.read<unsigned char>() != 0;
    return reader;
}

template <typename T> Message& operator<<(Message& message, const std::vector<T>& values)
{
    message << values.size();
    if constexpr (Plain<T>)
        message.append(values.data(), values.size());
    else
        for (const T& value : values)
            message << value;
    return message;
}

template <typename T> Reader& operator>>(Reader& reader, std::vector<T>& values)
{
    const auto count = reader.read<std::size_t>();
    constexpr std::size_t least = Plain<T> ? sizeof(T) : sizeof(std::size_t); // bytes that a value takes
    if (count > reader.rest().size() / least) // no allocation on a liar's word
        throw MalformedMessage();
    values.resize(count);
    if constexpr (Plain<T>) {
        const auto bytes = reader.take(count * sizeof(T));
        std::copy(bytes.begin(), bytes.end(), std::as_writable_bytes(std::span(values)).begin());
    } else {
        for (T& value : values)
            reader >> value;
    }
    return reader;
}

template <typename... Ts> Message& operator<<(Message& message, const std::variant<Ts...>& value)
{
    message << value.index();
    std::visit([&](const auto& alternative) { message << alternative; }, value);
    return message;
}

template <typename... Ts> Reader& operator>>(Reader& reader, std::variant<Ts...>& value)
{
    const auto index = reader.read<std::size_t>();
    std::size_t i = 0;
    if (!((i++ == index ? (reader >> value.template emplace<Ts>(), true) : false) || ...)) // no such alternative
        throw MalformedMessage();
    return reader;
}

inline Message& operator<<(Message& message, const std::string& text)
{
    message << text.size();
    message.append(text.data(), text.size());
    return message;
}

inline Reader& operator>>(Reader& reader, std::string& text)
{
    const auto bytes = reader.take(reader.read<std::size_t>());
    text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return reader;
}

}
