#include "gui/raster_scene.h"
#include "gui/tessellate.h"
#include <algorithm>

namespace gui {
namespace {

    struct Box {
        glm::vec3 lower { std::numeric_limits<float>::max() }, upper { std::numeric_limits<float>::lowest() };

        void add(const glm::vec3& position)
        {
            lower = glm::min(lower, position);
            upper = glm::max(upper, position);
        }
    };

    Box boxAround(const Scene& scene)
    {
        Box box;
        for (const Mesh& mesh : scene.meshes)
            for (const Vertex& vertex : mesh.vertices)
                box.add(vertex.position);
        for (const Sphere& sphere : scene.spheres) {
            box.add(sphere.center - sphere.radius);
            box.add(sphere.center + sphere.radius);
        }
        return box;
    }

    bool isOpaque(const Material& material)
    {
        return material.transparency >= 1.0f;
    }

}

RasterScene::RasterScene(const Scene& scene)
{
    for (const Mesh& mesh : scene.meshes)
        add(mesh, false);
    for (const Sphere& sphere : scene.spheres)
        add(tessellate(sphere), true);
    std::ranges::stable_partition(m_parts, [](const Part& part) { return isOpaque(part.material); });
    if (m_parts.empty())
        return;
    const Box box = boxAround(scene);
    m_center = 0.5f * (box.lower + box.upper);
    m_radius = 0.5f * glm::distance(box.lower, box.upper);
}

void RasterScene::add(const Mesh& mesh, bool isRound)
{
    if (const Image* texture = mesh.material.kdTexture)
        m_textures.try_emplace(texture, *texture);
    m_parts.push_back({ MeshBuffer(mesh), mesh.material, isRound });
}

void RasterScene::draw(const ShaderProgram& program, const Features& features) const
{
    for (const Part& part : m_parts)
        draw(part, program, features);
    glDepthMask(GL_TRUE);
}

void RasterScene::draw(const Part& part, const ShaderProgram& program, const Features& features) const
{
    const Material& material = part.material;
    const bool isBlended = features.enableTransparency && !isOpaque(material);
    const bool isTextured = features.enableTextureMapping && material.kdTexture;
    if (isTextured)
        m_textures.at(material.kdTexture).bind(features.enableBilinearTextureFiltering);
    program.set("isTextured", isTextured);
    program.set("isSmooth", part.isRound || features.enableNormalInterp);
    program.set("kd", material.kd);
    program.set("alpha", isBlended ? material.transparency : 1.0f);
    glDepthMask(!isBlended); // what is behind glass that is drawn before it shows through, too
    part.buffer.draw();
}

}
