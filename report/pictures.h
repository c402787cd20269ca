#pragma once
#include "report/sheet.h"

namespace report {

// Pixels as squares of factor x factor, so that they are seen one by one.
[[nodiscard]] Picture magnified(const Picture& picture, int factor);

// The part of that size from that pixel on, counted from the bottom left.
[[nodiscard]] Picture crop(const Picture& picture, glm::ivec2 from, glm::ivec2 size);

// Absolute differences of two pictures of one size, times the gain.
[[nodiscard]] Picture difference(std::string label, const Picture& a, const Picture& b, float gain);

// Root of the mean squared difference over pixels and channels.
[[nodiscard]] double rmse(const Picture& a, const Picture& b);

// "error of <label>": the RMSE against the reference's picture, for the caption.
[[nodiscard]] Fact errorAgainst(const Picture& reference, const Picture& picture);

}
