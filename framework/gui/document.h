#pragma once
#include "config.h"
#include "scene.h"
#include <filesystem>
#include <vector>

namespace gui {

// What is seen and can be changed: where from, with what switched on, and by which lights.
struct Settings {
    Config config;
    std::vector<Scene::SceneLight> lights;
};

// A scene file that is open, with what was changed since.
class Document {
public:
    // Throws files::Error.
    explicit Document(std::filesystem::path path);

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    [[nodiscard]] const Scene& scene() const { return m_scene; } // but for its lights
    Settings settings;

    // Ends a change: what there was before can be had back. Of equal settings nothing is kept.
    void remember();
    [[nodiscard]] bool canUndo() const { return m_now > 0; }
    [[nodiscard]] bool canRedo() const { return m_now + 1 < m_states.size(); }
    void undo();
    void redo();

private:
    std::filesystem::path m_path;
    Scene m_scene;
    std::vector<Settings> m_states; // in the order of the changes
    std::size_t m_now = 0; // the one that is shown
};

// Whether nothing that is seen differs.
[[nodiscard]] bool areEqual(const Settings& a, const Settings& b);

}
