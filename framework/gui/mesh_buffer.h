#pragma once
#include "gui/gl_object.h"
#include <framework/mesh.h>

namespace gui {

// The triangles of a mesh in the graphics card. Vertex shaders find the position, the normal and the texture coordinate
// at locations 0, 1 and 2.
class MeshBuffer {
public:
    explicit MeshBuffer(const Mesh& mesh);

    void draw() const;

private:
    using Buffer = GlObject<destroyOne<glDeleteBuffers>>;

    GlObject<destroyOne<glDeleteVertexArrays>> m_array { generateOne<glGenVertexArrays>() };
    Buffer m_vertices { generateOne<glGenBuffers>() }, m_triangles { generateOne<glGenBuffers>() };
    GLsizei m_numIndices;
};

}
