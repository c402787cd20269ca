#pragma once
#include <glm/vec3.hpp>
#include <span>

namespace bench {

// Root mean square of what a picture errs, as it is shown: in [0, 1].
[[nodiscard]] double pictureError(std::span<const glm::vec3> picture, std::span<const glm::vec3> truth);

}
