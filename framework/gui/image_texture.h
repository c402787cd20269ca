#pragma once
#include "gui/gl_object.h"
#include <framework/image.h>

namespace gui {

// A material's picture in the graphics card, clamped at its edge.
class ImageTexture {
public:
    explicit ImageTexture(const Image& image);

    // For samplers that read texture unit 0.
    void bind(bool isBilinear) const;

private:
    GlObject<destroyOne<glDeleteTextures>> m_texture { generateOne<glGenTextures>() };
};

}
