#pragma once
#include "worker/debug_ray.h"
#include <string>

namespace app {

// All that is known of a debug ray:
//   {"size": [w, h], "pixel": [x, y], "color": [r, g, b], "dropped": n,
//    "shapes": [{"bounce": n, "way": "path" or "shadow", "type": "ray", "box", "triangle" or "sphere", ...}],
//    "hits": [{"bounce", "way", "point", "normal", "barycentric", "texCoord", "kd", "ks", "transparency"}],
//    "lookups": [{"bounce", "way", "texture": index, "size", "texCoord", "texels": [{"index": [i, j], "weight"}]}],
//    "samples": [[x, y]]}
// A shape has the arguments of the function of draw.h that drew it. Pixels and rows are counted from the bottom left.
[[nodiscard]] std::string toJson(const worker::DebugRay& ray);

}
