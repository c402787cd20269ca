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
    // transparency is on, what lets light through comes last, blended over the rest.
    void draw(const ShaderProgram& program, const Features& features) const;

    // A ball around all that there is.
    [[nodiscard]] const glm::vec3& center() const { return m_center; }
    [[nodiscard]] float radius() const { return m_radius; }

private:
    struct Part {
        MeshBuffer buffer;
        Material material;
        bool isRound; // whatever the features say
    };

    void add(const Mesh& mesh, bool isRound);
    void draw(const Part& part, const ShaderProgram& program, const Features& features) const;

    std::vector<Part> m_parts; // the opaque ones first
    std::map<const Image*, ImageTexture> m_textures;
    glm::vec3 m_center { 0.0f };
    float m_radius = 0.0f;
};

}
