#include "screen.h"
#include "files/bitmap.h"
#include <algorithm>

Screen::Screen(const glm::ivec2& resolution)
    : m_resolution(resolution)
    , m_pixels(static_cast<std::size_t>(resolution.x) * static_cast<std::size_t>(resolution.y), glm::vec3(0.0f))
{
}

void Screen::clear(const glm::vec3& color)
{
    std::fill(m_pixels.begin(), m_pixels.end(), color);
    m_rowsStarted = 0;
}

void Screen::setPixel(int x, int y, const glm::vec3& color)
{
    if (x == 0)
        m_rowsStarted.fetch_add(1, std::memory_order_relaxed);
    m_pixels[static_cast<std::size_t>(indexAt(x, y))] = color;
}

void Screen::writeBitmapToFile(const std::filesystem::path& path) const
{
    files::saveBitmap(path, m_resolution, m_pixels);
}
