#include "gui/picture_texture.h"
#include <GL/gl.h>
#include <imgui.h>

namespace gui {

PictureTexture::PictureTexture()
{
    glGenTextures(1, &m_name);
    glBindTexture(GL_TEXTURE_2D, m_name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

PictureTexture::~PictureTexture()
{
    glDeleteTextures(1, &m_name);
}

void PictureTexture::upload(const Picture& picture)
{
    m_size = picture.size;
    glBindTexture(GL_TEXTURE_2D, m_name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, m_size.x, m_size.y, 0, GL_RGB, GL_FLOAT, picture.pixels.data());
}

// Its first row is at the bottom.
void PictureTexture::drawBehind(glm::vec2 first, glm::vec2 last) const
{
    if (m_size.x > 0)
        ImGui::GetBackgroundDrawList()->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(m_name)),
            { first.x, first.y }, { last.x, last.y }, { 0.0f, 1.0f }, { 1.0f, 0.0f });
}

}
