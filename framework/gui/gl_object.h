#pragma once
#include <GL/gl.h>
#include <GL/glext.h>
#include <utility>

namespace gui {

// Owns an object of OpenGL, which knows it by a number. Needs a current context.
template <void (*destroy)(GLuint)> class GlObject {
public:
    explicit GlObject(GLuint number)
        : m_number(number)
    {
    }
    GlObject(GlObject&& other) noexcept
        : m_number(std::exchange(other.m_number, 0u))
    {
    }
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(m_number, other.m_number);
        return *this;
    }
    ~GlObject() { destroy(m_number); } // 0 is ignored

    [[nodiscard]] GLuint number() const { return m_number; }

private:
    GLuint m_number;
};

// For the objects that OpenGL makes and destroys several at a time.
template <void (*generate)(GLsizei, GLuint*)> [[nodiscard]] GLuint generateOne()
{
    GLuint number = 0;
    generate(1, &number);
    return number;
}

template <void (*destroy)(GLsizei, const GLuint*)> void destroyOne(GLuint number)
{
    destroy(1, &number);
}

}
