#include "gui/mesh_buffer.h"
#include <cstddef>

namespace gui {
namespace {

    template <typename T> void upload(GLenum target, GLuint buffer, const std::vector<T>& values)
    {
        glBindBuffer(target, buffer);
        glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
    }

    void addAttribute(GLuint location, GLint numFloats, std::size_t offset)
    {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(
            location, numFloats, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
    }

}

MeshBuffer::MeshBuffer(const Mesh& mesh)
    : m_numIndices(static_cast<GLsizei>(3 * mesh.triangles.size()))
{
    glBindVertexArray(m_array.number()); // remembers all that follows
    upload(GL_ARRAY_BUFFER, m_vertices.number(), mesh.vertices);
    upload(GL_ELEMENT_ARRAY_BUFFER, m_triangles.number(), mesh.triangles);
    addAttribute(0, 3, offsetof(Vertex, position));
    addAttribute(1, 3, offsetof(Vertex, normal));
    addAttribute(2, 2, offsetof(Vertex, texCoord));
    glBindVertexArray(0);
}

void MeshBuffer::draw() const
{
    glBindVertexArray(m_array.number());
    glDrawElements(GL_TRIANGLES, m_numIndices, GL_UNSIGNED_INT, nullptr);
}

}
