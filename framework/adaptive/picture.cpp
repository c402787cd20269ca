#include "adaptive/picture.h"
#include "adaptive/believed_errors.h"
#include <tbb/parallel_for.h>

namespace adaptive {

Picture::Picture(const PixelRays& rays, glm::ivec2 size)
    : m_rays(rays)
    , m_size(size)
    , m_estimates(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y))
{
    constexpr uint32_t quarter = fewestRays / 4;
    tbb::parallel_for(std::size_t(0), m_estimates.size(), [&](std::size_t pixel) {
        const auto mean = [&](uint32_t i) { return m_rays.mean(pixel, i * quarter, quarter); };
        m_estimates[pixel] = estimateFrom({ mean(0), mean(1), mean(2), mean(3) }, fewestRays);
    });
    m_errors = believedErrors(m_estimates, m_size);
}

bool Picture::refineAbove(double error, const std::function<bool()>& goesOn)
{
    const std::vector<std::size_t> pixels = pixelsAbove(error);
    tbb::parallel_for(std::size_t(0), pixels.size(), [&](std::size_t i) {
        if (goesOn())
            refine(pixels[i]);
    });
    m_errors = believedErrors(m_estimates, m_size);
    return !pixels.empty();
}

std::vector<std::size_t> Picture::pixelsAbove(double error) const
{
    std::vector<std::size_t> pixels;
    for (std::size_t pixel = 0; pixel < m_errors.size(); ++pixel)
        if (m_errors[pixel] > error && m_estimates[pixel].numRays < mostRays)
            pixels.push_back(pixel);
    return pixels;
}

void Picture::refine(std::size_t pixel)
{
    Estimate& estimate = m_estimates[pixel];
    const uint32_t numRays = estimate.numRays, half = numRays / 2;
    estimate = doubled(estimate, { m_rays.mean(pixel, numRays, half), m_rays.mean(pixel, numRays + half, half) });
}

}
