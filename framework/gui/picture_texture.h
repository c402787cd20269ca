#pragma once
#include "gui/exchange.h"
#include <glm/vec2.hpp>

namespace gui {

// A picture in the graphics card. Needs a current OpenGL context.
class PictureTexture {
public:
    PictureTexture();
    ~PictureTexture();
    PictureTexture(const PictureTexture&) = delete;
    PictureTexture& operator=(const PictureTexture&) = delete;

    void upload(const Picture& picture);

    // Draws it behind all panels, over this area of the window.
    void drawBehind(glm::vec2 first, glm::vec2 last) const;

private:
    unsigned m_name = 0;
    glm::ivec2 m_size { 0 };
};

}
