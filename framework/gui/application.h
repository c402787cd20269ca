#pragma once
#include "gui/document.h"
#include "gui/light_handles.h"
#include "gui/output_panel.h"
#include "gui/picture_texture.h"
#include "gui/profiler_strip.h"
#include "gui/raster_view.h"
#include "gui/ray_panel.h"
#include "gui/save_panel.h"
#include "gui/scene_panel.h"
#include "gui/texture_panel.h"
#include "gui/tracer.h"
#include "gui/tree_panel.h"
#include "gui/window.h"

namespace gui {

// What the window shows, frame by frame: a scene traced by a submission's code, and what can be changed about it.
class Application {
public:
    // Throws files::Error.
    Application(const std::filesystem::path& scene, const std::filesystem::path& submission);

    // Between beginFrame and drawFrame of the window.
    void frame(Window& window);

    [[nodiscard]] const Document& document() const { return m_document; }
    [[nodiscard]] Document& document() { return m_document; }
    [[nodiscard]] const RayPanel& ray() const { return m_ray; }
    [[nodiscard]] const std::string& saved() const { return m_save.outcome(); }
    [[nodiscard]] const OutputLines& printed() const { return m_output.printed(); }
    [[nodiscard]] const TreePanel& tree() const { return m_tree; }
    // The newest, be it of what is asked for now or of before.
    [[nodiscard]] const Picture& picture() const { return m_picture; }
    [[nodiscard]] bool isPictureCurrent() const { return m_picture.number == m_number; }
    [[nodiscard]] bool isPictureDone() const { return isPictureCurrent() && m_picture.isDone; }
    [[nodiscard]] std::string message() { return m_error + m_tracer.message(); }

private:
    void sidePanel();
    void status();
    void control(const std::vector<std::string>& keys);
    void press(const std::string& key);
    void orbit();
    void followRay();
    void showView();
    void setRasterised(bool isRasterised);
    void showQuantity(debug::Quantity quantity);
    void drawRasterised();
    void open(const std::filesystem::path& path);
    [[nodiscard]] worker::View view() const;

    Document m_document;
    Tracer m_tracer;
    PictureTexture m_texture;
    Picture m_picture; // the newest
    std::optional<RasterView> m_raster; // of the document, once it has been looked at
    RayPanel m_ray;
    TreePanel m_tree;
    ScenePanel m_scene;
    SavePanel m_save;
    OutputPanel m_output;
    ProfilerStrip m_profiler;
    TexturePanel m_textureSpace;
    LightHandles m_lightHandles;
    std::optional<Settings> m_shown; // what the tracer was asked for last
    bool m_isCounted = false; // likewise
    glm::vec2 m_first { 0.0f }, m_last { 1.0f }; // of the picture in the window
    uint64_t m_number = 0; // of the view that was asked for last; pictures that are waited for have it
    bool m_showsHelp = false;
    bool m_isRasterised = false, m_isWireframe = false;
    debug::Quantity m_quantity = debug::Quantity::Color; // of what is traced
    std::string m_error; // of what the user asked for
};

}
