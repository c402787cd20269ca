#include "gui/raster_scene.h"
#include "accel/bounds.h"
#include "gui/tessellate.h"
#include <algorithm>
#include <functional>

namespace gui {
namespace {

    AxisAlignedBox boxAround(const Mesh& mesh)
    {
        AxisAlignedBox box = accel::emptyBox();
        for (const Vertex& vertex : mesh.vertices)
            box = accel::unite(box, vertex.position);
        return box;
    }

    bool isBlended(const Material& material, const Features& features)
    {
        return features.enableTransparency && material.transparency < 1.0f;
    }

}

RasterScene::RasterScene(const Scene& scene)
    : m_box(accel::emptyBox())
{
    for (const Mesh& mesh : scene.meshes)
        add(mesh, false);
    for (const Sphere& sphere : scene.spheres)
        add(tessellate(sphere), true);
    if (m_parts.empty())
        m_box = {};
}

void RasterScene::add(const Mesh& mesh, bool isRound)
{
    if (mesh.triangles.empty())
        return;
    if (const Image* texture = mesh.material.kdTexture)
        m_textures.try_emplace(texture, *texture);
    const AxisAlignedBox box = boxAround(mesh);
    m_parts.push_back({ MeshBuffer(mesh), mesh.material, isRound, 0.5f * (box.lower + box.upper) });
    m_box = accel::unite(m_box, box);
}

void RasterScene::draw(const ShaderProgram& program, const Features& features, const glm::vec3& eye) const
{
    std::vector<const Part*> blended;
    for (const Part& part : m_parts)
        if (isBlended(part.material, features))
            blended.push_back(&part);
        else
            draw(part, program, features);
    const auto distance = [&](const Part* part) { return glm::distance(part->center, eye); };
    std::ranges::sort(blended, std::greater(), distance);
    glDepthMask(GL_FALSE); // the far side of a body that is drawn after its near side shows through, too
    for (const Part* part : blended)
        draw(*part, program, features);
    glDepthMask(GL_TRUE);
}

void RasterScene::draw(const Part& part, const ShaderProgram& program, const Features& features) const
{
    const Material& material = part.material;
    const bool isTextured = features.enableTextureMapping && material.kdTexture;
    if (isTextured)
        m_textures.at(material.kdTexture).bind(features.enableBilinearTextureFiltering);
    program.set("isTextured", isTextured);
    program.set("isSmooth", part.isRound || features.enableNormalInterp);
    program.set("kd", material.kd);
    program.set("alpha", isBlended(material, features) ? material.transparency : 1.0f);
    part.buffer.draw();
}

}
