#pragma once
#include "adaptive/estimate.h"
#include "adaptive/pixel_rays.h"
#include <functional>
#include <vector>

namespace adaptive {

// A picture whose pixels have as many rays as each needs. The same for any number of threads: what is refined is
// decided between rounds, from the whole picture.
class Picture {
public:
    static constexpr uint32_t fewestRays = 8; // a pixel: what none of them and of the neighbours' meets stays unseen
    static constexpr uint32_t mostRays = 1u << 20;

    // Every pixel has the fewest rays.
    Picture(const PixelRays& rays, glm::ivec2 size);

    // Doubles the rays of each pixel whose error is believed to be above this one, while it goes on. Whether there was
    // any.
    bool refineAbove(double error, const std::function<bool()>& goesOn);

    // One a pixel, row 0 at the bottom.
    [[nodiscard]] const std::vector<Estimate>& estimates() const { return m_estimates; }
    [[nodiscard]] const std::vector<double>& errors() const { return m_errors; } // believed

private:
    [[nodiscard]] std::vector<std::size_t> pixelsAbove(double error) const;
    void refine(std::size_t pixel);

    const PixelRays& m_rays;
    glm::ivec2 m_size;
    std::vector<Estimate> m_estimates;
    std::vector<double> m_errors;
};

}
