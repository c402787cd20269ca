#include "gui/image_texture.h"

namespace gui {

ImageTexture::ImageTexture(const Image& image)
{
    std::vector<glm::vec3> texels; // of three channels, whatever the image has
    for (int i = 0; i < image.width * image.height; ++i)
        texels.push_back(image.get_pixel(i));
    glBindTexture(GL_TEXTURE_2D, m_texture.number());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void ImageTexture::bind(bool isBilinear) const
{
    const GLint filter = isBilinear ? GL_LINEAR : GL_NEAREST;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, m_texture.number());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

}
