#pragma once
#include <framework/trackball.h>

namespace values {

// The camera's ray through the centre of a pixel.
[[nodiscard]] inline Ray centreRay(const Trackball& camera, glm::ivec2 pixel, glm::ivec2 resolution)
{
    return camera.generateRay((glm::vec2(pixel) + 0.5f) / glm::vec2(resolution) * 2.0f - 1.0f);
}

}
