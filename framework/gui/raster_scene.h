#pragma once
#include "gui/image_texture.h"
#include "gui/mesh_buffer.h"
#include "gui/shader_program.h"
#include "scene.h"
#include <map>

namespace gui {

// A scene in the graphics card.
class RasterScene {
public:
    explicit RasterScene(const Scene& scene);

    // Draws it with the program of raster_shaders.h; sets the uniforms that tell one material from another. Where
    // transparency is on, what lets light through comes last, blended over the rest from far to near.
    void draw(const ShaderProgram& program, const Features& features, const glm::vec3& eye) const;

    // A ball around all that there is.
    [[nodiscard]] glm::vec3 center() const { return 0.5f * (m_box.lower + m_box.upper); }
    [[nodiscard]] float radius() const { return 0.5f * glm::distance(m_box.lower, m_box.upper); }

private:
    struct Part {
        MeshBuffer buffer;
        Material material;
        bool isRound; // whatever the features say
        glm::vec3 center;
    };

    void add(const Mesh& mesh, bool isRound);
    void draw(const Part& part, const ShaderProgram& program, const Features& features) const;

    std::vector<Part> m_parts;
    std::map<const Image*, ImageTexture> m_textures;
    AxisAlignedBox m_box;
};

}
