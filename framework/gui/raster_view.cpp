#include "gui/raster_view.h"
#include "gui/clip_matrix.h"
#include "gui/raster_lights.h"
#include "gui/raster_shaders.h"
#include <imgui.h>

namespace gui {

static ShaderProgram makeProgram(std::size_t numLights)
{
    const std::string fragmentShader = rasterFragmentHead(numLights) + rasterFragmentShader;
    return { rasterVertexShader, fragmentShader.c_str() };
}

RasterView::RasterView(const Scene& scene)
    : m_lights(1)
    , m_program(makeProgram(m_lights.size()))
    , m_scene(scene)
{
}

// ImGui draws at the end of the frame: it calls back when what lies behind has been drawn, and nothing above yet.
void RasterView::drawBehind(const worker::View& view, bool isWireframe, glm::vec2 first, glm::vec2 last)
{
    m_view = view;
    const std::size_t numLights = std::exchange(m_lights, rasterLights(view)).size();
    if (m_lights.size() != numLights)
        m_program = makeProgram(m_lights.size());
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
    for (std::size_t i = 0; i < m_lights.size(); ++i) {
        m_program.set(fmt::format("lights[{}]", i), m_lights[i].position - m_view.camera.position());
        m_program.set(fmt::format("lightColors[{}]", i), m_lights[i].color);
    }
}

}
