#pragma once
#include <unistd.h>
#include <utility>

namespace sandbox {

// A file descriptor that is closed when this goes; -1 is none.
class File {
public:
    File() = default;
    explicit File(int descriptor)
        : m_descriptor(descriptor)
    {
    }
    ~File()
    {
        if (m_descriptor >= 0)
            close(m_descriptor);
    }
    File(File&& other) noexcept
        : m_descriptor(std::exchange(other.m_descriptor, -1))
    {
    }
    File& operator=(File&& other) noexcept
    {
        std::swap(m_descriptor, other.m_descriptor);
        return *this;
    }

    operator int() const { return m_descriptor; }

private:
    int m_descriptor = -1;
};

}
