#include "gui/application.h"
#include "files/camera_file.h"
#include "files/error.h"
#include "gui/false_color_panel.h"
#include "gui/orbit.h"
#include "gui/panels.h"
#include "gui/samples_panel.h"
#include "gui/scale.h"
#include "gui/work_panel.h"

namespace gui {

namespace fs = std::filesystem;

static constexpr float sideWidth = 360.0f; // pixels of an ordinary screen

Application::Application(const fs::path& scene, const fs::path& submission)
    : m_document(scene)
    , m_tracer(submission)
{
}

void Application::frame(Window& window)
{
    m_first = { sideWidth * scale(), 0.0f };
    m_last = glm::max(glm::vec2(window.size()) - glm::vec2(0.0f, ProfilerStrip::height()), m_first + 16.0f);
    if (const auto dropped = window.takeDropped())
        open(*dropped);
    control(window.takeKeys());
    sidePanel();
    m_profiler.show(m_picture, { 0.0f, m_last.y }, window.size());
    workPanel(m_picture, m_document.settings.config.features.extra.enableSkipping, m_profiler.isCounting,
        { m_first.x, m_last.y });
    helpPanel(m_showsHelp);
    if (const auto& ray = m_ray.followed()) {
        m_textureSpace.show(*ray, m_document.scene());
        samplesPanel(*ray, m_document.settings.config.features, m_last);
    }
    if (!ImGui::IsAnyItemActive() && !ImGui::IsAnyMouseDown())
        m_document.remember();
    showView();
}

worker::View Application::view() const
{
    Config config = m_document.settings.config;
    config.size = glm::ivec2(m_last - m_first);
    return { makeTrackball(config), config.features, m_document.settings.lights, config.size, m_quantity,
        m_profiler.isCounting };
}

void Application::showView()
{
    Settings wanted = m_document.settings;
    wanted.config.size = glm::ivec2(m_last - m_first);
    if (!m_shown || !areEqual(wanted, *m_shown) || m_isCounted != m_profiler.isCounting) {
        m_number = m_tracer.show(m_document.path(), view());
        m_shown = std::move(wanted);
        m_isCounted = m_profiler.isCounting;
    }
    if (auto picture = m_tracer.takePicture()) {
        m_picture = std::move(*picture);
        m_texture.upload(m_picture);
    }
    if (auto ray = m_tracer.takeRay())
        m_ray.show(std::move(*ray));
    m_output.add(m_tracer.takePrinted());
    m_tracer.drawTree(m_tree.wanted());
    if (auto tree = m_tracer.takeTree())
        m_tree.show(std::move(*tree));
    if (m_isRasterised) {
        drawRasterised();
    } else {
        m_texture.drawBehind(m_first, m_last);
        legend(m_picture, m_first, m_last);
    }
    m_tree.drawOver(view().camera, m_first, m_last);
    m_ray.drawOver(view().camera, m_first, m_last);
    m_lightHandles.drawOver(m_document.settings.lights, view().camera, m_first, m_last);
}

void Application::drawRasterised()
{
    if (!m_raster)
        m_raster.emplace(m_document.scene());
    m_raster->drawBehind(view(), m_isWireframe, m_first, m_last);
}

// Rays can be followed in what is rasterised: the tracer knows the view, and leaves the cores alone.
void Application::setRasterised(bool isRasterised)
{
    m_isRasterised = isRasterised;
    m_tracer.setPaused(isRasterised);
}

void Application::showQuantity(debug::Quantity quantity)
{
    setRasterised(false);
    m_quantity = quantity;
    m_shown.reset();
}

void Application::sidePanel()
{
    ImGui::SetNextWindowPos({ 0.0f, 0.0f });
    ImGui::SetNextWindowSize({ m_first.x, m_last.y });
    ImGui::Begin("side", nullptr,
        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove
            | ImGuiWindowFlags_NoBringToFrontOnFocus);
    status();
    if (ImGui::CollapsingHeader("scene", ImGuiTreeNodeFlags_DefaultOpen))
        if (const auto picked = m_scene.pick(m_document.path()))
            open(*picked);
    if (ImGui::CollapsingHeader("save"))
        m_save.show(m_document, m_picture, glm::ivec2(m_last - m_first));
    m_output.show(); // above what fills the panel, since it opens by itself
    if (ImGui::CollapsingHeader("features", ImGuiTreeNodeFlags_DefaultOpen))
        featuresPanel(m_document.settings.config.features);
    if (ImGui::CollapsingHeader("camera"))
        cameraPanel(m_document.settings.config.camera);
    if (ImGui::CollapsingHeader("lights")) {
        m_lightHandles.showSwitch();
        lightsPanel(m_document.settings.lights);
    }
    if (ImGui::CollapsingHeader("tree"))
        m_tree.controls();
    if (m_ray.isToBeSeen())
        ImGui::SetNextItemOpen(true);
    if (ImGui::CollapsingHeader("ray", ImGuiTreeNodeFlags_DefaultOpen))
        m_ray.list();
    ImGui::End();
}

void Application::status()
{
    if (ImGui::RadioButton("traced", !m_isRasterised))
        setRasterised(false);
    ImGui::SameLine();
    if (ImGui::RadioButton("rasterised", m_isRasterised))
        setRasterised(true);
    ImGui::SameLine();
    ImGui::TextDisabled("? for help");
    if (m_isRasterised)
        ImGui::Checkbox("wireframe", &m_isWireframe);
    else if (const auto chosen = quantityCombo(m_quantity))
        showQuantity(*chosen);
    const std::string text = message();
    ImGui::PushStyleColor(ImGuiCol_Text, { 1.0f, 0.5f, 0.4f, 1.0f });
    if (!text.empty())
        ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

void Application::open(const fs::path& path)
{
    try {
        m_error.clear();
        if (files::isCameraFile(path)) {
            m_document.settings.config.camera = files::loadCamera(path);
            return;
        }
        m_document = Document(path);
        m_shown.reset();
        m_raster.reset();
        m_ray.forget();
        m_tree.forget();
    } catch (const files::Error& error) {
        m_error = std::string(error.what()) + "\n";
    }
}

// The keys and the mouse, where no panel wants them.
void Application::control(const std::vector<std::string>& keys)
{
    const ImGuiIO& io = ImGui::GetIO();
    m_lightHandles.control(m_document.settings.lights, view().camera, m_first, m_last);
    if (!m_lightHandles.isUnderMouse())
        m_ray.control(view().camera, m_first, m_last);
    if (!io.WantCaptureMouse)
        orbit();
    if (!io.WantTextInput)
        std::ranges::for_each(keys, [&](const std::string& key) { press(key); });
}

void Application::press(const std::string& key)
{
    if (key == "ctrl+z")
        m_document.undo();
    else if (key == "ctrl+y")
        m_document.redo();
    else if (key == "r")
        followRay();
    else if (key == "t")
        setRasterised(!m_isRasterised);
    else if (key == "f")
        showQuantity(debug::nextOf(m_quantity));
    else if (key == "?")
        m_showsHelp = !m_showsHelp;
    else if (key == "escape")
        m_ray.forget();
}

void Application::orbit()
{
    const ImGuiIO& io = ImGui::GetIO();
    CameraConfig& camera = m_document.settings.config.camera;
    const float height = m_last.y - m_first.y;
    const glm::vec2 dragged { io.MouseDelta.x / height, io.MouseDelta.y / height };
    // In the frame in which a button goes down, the mouse has come from wherever it was.
    const auto isDragging = [&](ImGuiMouseButton button) { return io.MouseDownDuration[button] > 0.0f; };
    if (isDragging(ImGuiMouseButton_Left) && !m_lightHandles.isDragging() && dragged != glm::vec2(0.0f))
        turn(camera, dragged);
    if (isDragging(ImGuiMouseButton_Right) && dragged != glm::vec2(0.0f))
        pan(camera, dragged);
    if (io.MouseWheel != 0.0f)
        zoom(camera, io.MouseWheel);
}

void Application::followRay()
{
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const glm::ivec2 pixel { static_cast<int>(mouse.x - m_first.x), static_cast<int>(m_last.y - mouse.y) };
    const glm::ivec2 size { m_last - m_first };
    if (glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel, size)))
        m_tracer.follow(pixel);
}

}
