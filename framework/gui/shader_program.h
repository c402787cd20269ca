#pragma once
#include "gui/gl_object.h"
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace gui {

// What the graphics card does with vertices and with fragments.
class ShaderProgram {
public:
    // Sources in GLSL. Throws NoWindow with the log of the driver that refuses them.
    ShaderProgram(const char* vertexSource, const char* fragmentSource);

    void use() const;

    // Uniforms, by name, of the program that is used.
    void set(const std::string& name, bool value) const;
    void set(const std::string& name, float value) const;
    void set(const std::string& name, const glm::vec3& value) const;
    void set(const std::string& name, const glm::mat4& value) const;

private:
    [[nodiscard]] GLint uniform(const std::string& name) const;

    GlObject<glDeleteProgram> m_program;
};

}
