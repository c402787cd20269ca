#pragma once
#include "worker/debug_ray.h"

namespace gui {

// A window with a pixel far magnified, and where its rays go through it. Nothing when there are none. At first it
// stands in this corner, of which it is on the left and above.
void samplesPanel(const worker::DebugRay& ray, const Features& features, glm::vec2 corner);

}
