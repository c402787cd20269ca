#include "worker/message.h"

namespace worker {

void Message::appendBytes(const void* bytes, std::size_t count)
{
    if (count == 0)
        return;
    const std::size_t size = m_bytes.size();
    m_bytes.resize(size + count);
    std::memcpy(m_bytes.data() + size, bytes, count);
}

}
