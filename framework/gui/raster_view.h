#pragma once
#include "gui/raster_scene.h"
#include "worker/view.h"

struct ImDrawCmd;
struct ImDrawList;

namespace gui {

// A scene drawn by the graphics card, at the rate of the window, where the tracer's picture would show it: a first
// look, without shadows, highlights and reflections.
class RasterView {
public:
    // Throws NoWindow.
    explicit RasterView(const Scene& scene);
    RasterView(const RasterView&) = delete;
    RasterView& operator=(const RasterView&) = delete;

    // Draws it behind all panels, over this area of the window. It has to live until the end of the frame.
    void drawBehind(const worker::View& view, bool isWireframe, glm::vec2 first, glm::vec2 last);

private:
    static void onDraw(const ImDrawList*, const ImDrawCmd* command);
    void draw() const;
    void setLights() const;

    std::vector<PointLight> m_lights;
    ShaderProgram m_program; // for so many lights
    RasterScene m_scene;
    worker::View m_view; // as of this frame, like all that follows
    bool m_isWireframe = false;
    glm::ivec2 m_corner { 0 }, m_size { 0 }; // pixels; the corner at the bottom left, from the window's
};

}
