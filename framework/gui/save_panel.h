#pragma once
#include "gui/document.h"
#include "gui/exchange.h"
#include <string>

namespace gui {

// Saves what is seen under a name that its user types: the scene as a file that `render` makes the same picture from,
// the picture itself as it is, and the camera alone, which can be taken over from there again.
class SavePanel {
public:
    // area: of the picture in the window, in pixels.
    void show(Document& document, const Picture& picture, glm::ivec2 area);

    // What came of the last attempt, as it is told.
    [[nodiscard]] const std::string& outcome() const { return m_outcome; }

private:
    void saveScene(const Document& document, glm::ivec2 area);
    void savePicture(const Picture& picture);
    void cameraButtons(CameraConfig& camera);
    template <typename Action> void attempt(const char* done, const std::string& extension, const Action& action);

    std::string m_name = "saved"; // a path without extension
    std::string m_outcome;
};

}
