#pragma once
#include <framework/trackball.h>

namespace worker {

// Through the middle of a pixel of a picture of that size.
[[nodiscard]] inline Ray middleRay(const Trackball& camera, glm::ivec2 pixel, glm::ivec2 size)
{
    return camera.generateRay((glm::vec2(pixel) + 0.5f) / glm::vec2(size) * 2.0f - 1.0f);
}

}
