#include "gui/panels.h"
#include <imgui.h>

namespace gui {

void cameraPanel(CameraConfig& camera)
{
    ImGui::DragFloat3("look at", &camera.lookAt.x, 0.01f);
    ImGui::DragFloat3("rotation", &camera.rotation.x, 0.5f, -360.0f, 360.0f, "%.1f deg");
    ImGui::DragFloat("distance", &camera.distanceFromLookAt, 0.01f, 1e-3f, 1e4f);
    ImGui::SliderFloat("field of view", &camera.fieldOfView, 1.0f, 170.0f, "%.1f deg");
}

}
