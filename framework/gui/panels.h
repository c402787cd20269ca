#pragma once
#include "gui/document.h"

namespace gui {

// Parts of the window's side. Each changes the settings that it shows.
void featuresPanel(Features& features);
void cameraPanel(CameraConfig& camera);
void lightsPanel(std::vector<Scene::SceneLight>& lights);
void helpPanel(bool& isOpen);

}
