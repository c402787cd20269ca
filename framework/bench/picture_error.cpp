#include "bench/picture_error.h"
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace bench {

double pictureError(std::span<const glm::vec3> picture, std::span<const glm::vec3> truth)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const glm::dvec3 difference
            = glm::dvec3(glm::clamp(picture[i], 0.0f, 1.0f)) - glm::dvec3(glm::clamp(truth[i], 0.0f, 1.0f));
        sum += glm::dot(difference, difference) / 3.0;
    }
    return std::sqrt(sum / static_cast<double>(picture.size()));
}

}
