#include "debug/recording.h"

namespace debug {

Recording::Recording(std::size_t capacity)
    : m_capacity(capacity)
    , m_outer(s_innermost)
{
    s_innermost = this;
}

Recording::~Recording()
{
    s_innermost = m_outer;
}

void Recording::add(const Drawn& shape)
{
    if (!s_innermost)
        return;
    if (s_innermost->m_shapes.size() < s_innermost->m_capacity)
        s_innermost->m_shapes.push_back(shape);
    else
        ++s_innermost->m_numDropped;
}

}
