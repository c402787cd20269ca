#pragma once
#include "worker/debug_ray.h"

namespace gui {

// A window with a pixel far magnified, and where its rays go through it. Nothing when there are none.
void samplesPanel(const worker::DebugRay& ray, const Features& features);

}
