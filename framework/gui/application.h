#pragma once
#include "gui/document.h"
#include "gui/picture_texture.h"
#include "gui/raster_view.h"
#include "gui/ray_panel.h"
#include "gui/tracer.h"

namespace gui {

// What the window shows, frame by frame: a scene traced by a submission's code, and what can be changed about it.
class Application {
public:
    // Throws files::Error.
    Application(const std::filesystem::path& scene, const std::filesystem::path& submission);

    // Between beginFrame and endFrame of the window, which has this size.
    void frame(glm::ivec2 windowSize);

    [[nodiscard]] const Document& document() const { return m_document; }
    [[nodiscard]] const RayPanel& ray() const { return m_ray; }
    [[nodiscard]] bool isPictureDone() const { return m_isPictureDone; }
    [[nodiscard]] std::string message() { return m_tracer.message(); }

private:
    void sidePanel();
    void status();
    void control();
    void orbit();
    void followRay();
    void showView();
    void setRasterised(bool isRasterised);
    void drawRasterised();
    void openScene(const std::filesystem::path& path);
    [[nodiscard]] worker::View view() const;

    Document m_document;
    Tracer m_tracer;
    PictureTexture m_texture;
    std::optional<RasterView> m_raster; // of the document, once it has been looked at
    RayPanel m_ray;
    std::optional<Settings> m_shown; // what the tracer was asked for last
    glm::vec2 m_first { 0.0f }, m_last { 1.0f }; // of the picture in the window
    bool m_isPictureDone = false, m_showsHelp = false;
    bool m_isRasterised = false, m_isWireframe = false;
    std::string m_error; // of what the user asked for
    double m_seconds = 0.0, m_raysPerSecond = 0.0;
};

}
