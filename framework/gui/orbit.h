#pragma once
#include "config.h"

namespace gui {

// What the mouse does to a camera. Distances in shares of the picture's height.
void turn(CameraConfig& camera, glm::vec2 dragged); // about what it looks at: half a turn for the whole height
void pan(CameraConfig& camera, glm::vec2 dragged); // so that what it looks at stays under the mouse
void zoom(CameraConfig& camera, float steps); // a tenth closer for each

}
