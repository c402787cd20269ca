#include "gui/shader_program.h"
#include "gui/window.h"
#include <glm/gtc/type_ptr.hpp>

namespace gui {
namespace {

    using Shader = GlObject<glDeleteShader>;

    // Shaders and programs have functions of the same shape to ask how they do.
    template <typename GetValue, typename GetLog>
    void check(const char* what, GLuint number, GLenum success, GetValue getValue, GetLog getLog)
    {
        GLint isGood = 0, length = 0;
        getValue(number, success, &isGood);
        if (isGood)
            return;
        getValue(number, GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(length), '\0');
        getLog(number, length, nullptr, log.data());
        throw NoWindow(std::string("OpenGL refuses a ") + what + ": " + log);
    }

    Shader compile(GLenum stage, const char* source)
    {
        Shader shader { glCreateShader(stage) };
        glShaderSource(shader.number(), 1, &source, nullptr);
        glCompileShader(shader.number());
        check("shader", shader.number(), GL_COMPILE_STATUS, glGetShaderiv, glGetShaderInfoLog);
        return shader;
    }

}

ShaderProgram::ShaderProgram(const char* vertexSource, const char* fragmentSource)
    : m_program(glCreateProgram())
{
    const Shader vertex = compile(GL_VERTEX_SHADER, vertexSource);
    const Shader fragment = compile(GL_FRAGMENT_SHADER, fragmentSource);
    glAttachShader(m_program.number(), vertex.number());
    glAttachShader(m_program.number(), fragment.number());
    glLinkProgram(m_program.number());
    check("program", m_program.number(), GL_LINK_STATUS, glGetProgramiv, glGetProgramInfoLog);
}

void ShaderProgram::use() const
{
    glUseProgram(m_program.number());
}

GLint ShaderProgram::uniform(const std::string& name) const
{
    return glGetUniformLocation(m_program.number(), name.c_str());
}

void ShaderProgram::set(const std::string& name, bool value) const
{
    glUniform1i(uniform(name), value);
}

void ShaderProgram::set(const std::string& name, float value) const
{
    glUniform1f(uniform(name), value);
}

void ShaderProgram::set(const std::string& name, const glm::vec3& value) const
{
    glUniform3fv(uniform(name), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const std::string& name, const glm::mat4& value) const
{
    glUniformMatrix4fv(uniform(name), 1, GL_FALSE, glm::value_ptr(value));
}

}
