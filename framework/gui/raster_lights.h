#pragma once
#include "worker/view.h"

namespace gui {

// The lights of a view as points: those with an extent shine from their middle, in their mean colour. Where there are
// none a white one at the camera shows the scene all the same.
[[nodiscard]] std::vector<PointLight> rasterLights(const worker::View& view);

}
