#pragma once
#include "gui/document.h"
#include "gui/exchange.h"
#include <string>

namespace gui {

// Saves what is seen under a name that its user types: the scene as a file that `render` makes the same picture from,
// and the picture itself as it is.
class SavePanel {
public:
    // area: of the picture in the window, in pixels.
    void show(const Document& document, const Picture& picture, glm::ivec2 area);

private:
    void saveScene(const Document& document, glm::ivec2 area);
    void savePicture(const Picture& picture);
    template <typename Save> void trySaving(const std::string& extension, const Save& save);

    std::string m_name = "saved"; // a path without extension
    std::string m_outcome; // of the last saving
};

}
