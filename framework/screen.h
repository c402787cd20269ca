#pragma once
#include <atomic>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

// The picture being rendered: linear colours, unclamped, row 0 at the bottom.
class Screen {
public:
    explicit Screen(const glm::ivec2& resolution);

    [[nodiscard]] glm::ivec2 resolution() const { return m_resolution; }
    [[nodiscard]] int indexAt(int x, int y) const { return y * m_resolution.x + x; }
    void clear(const glm::vec3& color);

    // Different pixels may be set from different threads at once.
    void setPixel(int x, int y, const glm::vec3& color);
    [[nodiscard]] std::vector<glm::vec3>& pixels() { return m_pixels; }
    [[nodiscard]] const std::vector<glm::vec3>& pixels() const { return m_pixels; }

    // How many rows have their first pixel: what a progress bar shows, at no cost a pixel.
    [[nodiscard]] int rowsStarted() const { return m_rowsStarted.load(std::memory_order_relaxed); }

    // Colours clamped to [0, 1], top row first. Throws files::Error when the file cannot be written.
    void writeBitmapToFile(const std::filesystem::path& path) const;

private:
    glm::ivec2 m_resolution;
    std::vector<glm::vec3> m_pixels;
    std::atomic<int> m_rowsStarted = 0;
};
