#include "gui/document.h"
#include "files/feature_settings.h"
#include "files/scene_file.h"
#include "worker/message.h"
#include <algorithm>

namespace gui {

Document::Document(std::filesystem::path path)
    : m_path(std::filesystem::absolute(path))
{
    auto [scene, config] = files::loadSceneFile(m_path);
    settings = { config, scene.lights };
    m_scene = std::move(scene);
    m_states.push_back(settings);
}

void Document::remember()
{
    if (areEqual(settings, m_states[m_now]))
        return;
    m_states.resize(m_now + 1); // another way was taken
    m_states.push_back(settings);
    ++m_now;
}

void Document::undo()
{
    if (canUndo())
        settings = m_states[--m_now];
}

void Document::redo()
{
    if (canRedo())
        settings = m_states[++m_now];
}

static bool areEqual(const CameraConfig& a, const CameraConfig& b)
{
    return a.lookAt == b.lookAt && a.rotation == b.rotation && a.distanceFromLookAt == b.distanceFromLookAt
        && a.fieldOfView == b.fieldOfView;
}

static bool areEqual(const std::vector<Scene::SceneLight>& a, const std::vector<Scene::SceneLight>& b)
{
    worker::Message first, second;
    first << a;
    second << b;
    return std::ranges::equal(first.bytes(), second.bytes());
}

bool areEqual(const Settings& a, const Settings& b)
{
    const auto isEqual = [&](const std::string& name) {
        return files::featureValue(a.config.features, name) == files::featureValue(b.config.features, name);
    };
    return areEqual(a.config.camera, b.config.camera) && a.config.size == b.config.size
        && std::ranges::all_of(files::featureNames(), isEqual) && areEqual(a.lights, b.lights);
}

}
