#include "debug/recording.h"
#include "draw.h"

namespace debug {

Recording::Recording(std::size_t capacity)
    : m_capacity(capacity)
    , m_outer(s_innermost)
{
    s_innermost = this;
    ++drawing::numListeners;
}

Recording::~Recording()
{
    s_innermost = m_outer;
    --drawing::numListeners;
}

template <typename Thing> void Recording::keep(std::vector<Thing>& things, const Thing& thing)
{
    if (m_shapes.size() + m_hits.size() + m_lookups.size() < m_capacity)
        things.push_back(thing);
    else
        ++m_numDropped;
}

void Recording::add(const Drawn& shape)
{
    if (s_innermost)
        s_innermost->keep(s_innermost->m_shapes, Shape { shape, Because::now() });
}

void Recording::addHit(const Ray& ray, const HitInfo& hitInfo)
{
    if (s_innermost)
        s_innermost->keep(s_innermost->m_hits, Hit { ray, hitInfo, Because::now() });
}

void Recording::addLookup(const Image& image, const glm::vec2& texCoord)
{
    if (s_innermost)
        s_innermost->keep(s_innermost->m_lookups, Lookup { &image, texCoord, Because::now() });
}

}
