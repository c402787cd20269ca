#include "gui/raster_view.h"
#include "gui/clip_matrix.h"
#include "gui/raster_lights.h"
#include "gui/raster_shaders.h"
#include <fmt/format.h>
#include <imgui.h>

namespace gui {

RasterView::RasterView(const Scene& scene)
    : m_program(rasterVertexShader, rasterFragmentShader)
    , m_scene(scene)
{
}

// ImGui draws at the end of the frame: it calls back when what lies behind has been drawn, and nothing above yet.
void RasterView::drawBehind(const worker::View& view, bool isWireframe, glm::vec2 first, glm::vec2 last)
{
    m_view = view;
    m_isWireframe = isWireframe;
    m_size = glm::ivec2(last - first);
    m_corner = glm::ivec2(first.x, ImGui::GetIO().DisplaySize.y - last.y);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddCallback(onDraw, this);
    list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

void RasterView::onDraw(const ImDrawList*, const ImDrawCmd* command)
{
    static_cast<const RasterView*>(command->UserCallbackData)->draw();
}

void RasterView::draw() const
{
    glViewport(m_corner.x, m_corner.y, m_size.x, m_size.y);
    glScissor(m_corner.x, m_corner.y, m_size.x, m_size.y); // which holds for clearing, too
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glPolygonMode(GL_FRONT_AND_BACK, m_isWireframe ? GL_LINE : GL_FILL);

    const Trackball& camera = m_view.camera;
    m_program.use();
    m_program.set("eye", camera.position());
    m_program.set("toClip", clipMatrix(camera, depthRange(camera, m_scene.center(), m_scene.radius())));
    m_program.set("isShaded", m_view.features.enableShading && !m_isWireframe); // a line has no normal
    setLights();
    m_scene.draw(m_program, m_view.features, camera.position());
}

void RasterView::setLights() const
{
    const std::vector<PointLight> lights = rasterLights(m_view);
    m_program.set("numLights", static_cast<int>(lights.size()));
    for (std::size_t i = 0; i < lights.size(); ++i) { // those that the shader has no room for are ignored
        m_program.set(fmt::format("lights[{}]", i), lights[i].position - m_view.camera.position());
        m_program.set(fmt::format("lightColors[{}]", i), lights[i].color);
    }
}

}
