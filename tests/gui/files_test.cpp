#include "changed_reference.h"
#include "files/camera_file.h"
#include "opened_window.h"
#include <catch2/catch.hpp>
#include <set>

// Files that are opened, dropped, saved and loaded in the window.

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using tests::OpenedWindow;

namespace {

const std::string triangleObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

// For as long as it lives; there the window saves what has no folder in its name.
class WorkingFolder {
public:
    explicit WorkingFolder(const fs::path& folder) { fs::current_path(folder); }
    ~WorkingFolder() { fs::current_path(m_before); }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

private:
    fs::path m_before = fs::current_path();
};

}

TEST_CASE("Every scene of the list can be opened from it", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    std::set<fs::path> scenes;
    for (const auto& entry : fs::directory_iterator(tests::source / "scenes"))
        if (entry.path().extension() == ".toml")
            scenes.insert(entry.path());
    CHECK(scenes.size() > 10);
    for (const fs::path& scene : scenes) {
        INFO(scene);
        window.choose("file", scene.stem().string());
        CHECK(window.application.document().path() == scene);
        window.drawUntil([&] { return window.application.isPictureCurrent(); });
        CHECK(window.application.message().empty());
    }
}

TEST_CASE("A scene or a model whose path is typed, or that is dropped on the window, is opened", "[window]")
{
    const files_test::TemporaryFolder folder;
    const fs::path scene = folder.write("a.toml", "size = [70, 70]\n[[mesh]]\nfile = \"b.obj\"\n");
    const fs::path model = folder.write("b.obj", triangleObj);
    OpenedWindow window { tests::cornell, tests::reference };
    const auto isOpened = [&](const fs::path& path) {
        window.drawUntilTraced();
        CHECK(window.application.message().empty());
        return window.application.document().path() == path && window.application.document().scene().meshes.size() == 1;
    };
    window.drop(scene);
    CHECK(isOpened(scene));
    window.drop(model);
    CHECK(isOpened(model));
    window.enter("open", scene.string());
    CHECK(isOpened(scene));
    window.enter("open", model.string());
    CHECK(isOpened(model));
}

TEST_CASE("A file that is not one to open is one message, and what was open stays, until a good one comes", "[window]")
{
    const files_test::TemporaryFolder folder;
    const auto [name, text, message] = GENERATE(table<std::string, std::string, std::string>({
        { "a.toml", "size = [0, 70]\n", "a.toml:1: found 0, expected" },
        { "a.toml", "[camera]\ndistance = \"far\"\n", "a.toml:2: found \"far\", expected" },
        { "a.toml", "[[mesh]]\nfile = \"b.obj\"\n", "b.obj: cannot be read" },
        { "a.obj", "v 0 0\n", "a.obj:1: " },
        { "a.png", "", "a.png: found the extension \".png\", expected" },
        { "a.toml/in_it", "", "a.toml: found a folder" },
    }));
    folder.write(name, text);
    const fs::path path = folder / name.substr(0, name.find('/'));
    OpenedWindow window { tests::cornell, tests::reference };
    const glm::vec3 rotation { 1.0f, 2.0f, 3.0f };
    window.application.document().settings.config.camera.rotation = rotation;
    window.drop(path);
    const std::string told = window.application.message();
    CHECK_THAT(told, Contains(message));
    CHECK(std::ranges::count(told, '\n') == 1);
    CHECK(window.application.document().path() == tests::cornell);
    CHECK(window.application.document().settings.config.camera.rotation == rotation);
    window.drawUntilTraced();
    window.enter("open", (folder / "none.toml").string());
    CHECK_THAT(window.application.message(), Contains("none.toml: cannot be read"));
    window.drop(tests::source / "scenes" / "cube.toml");
    CHECK(window.application.message().empty());
}

TEST_CASE("A camera that is saved is had back by its button, and by opening its file", "[window]")
{
    const files_test::TemporaryFolder folder;
    const WorkingFolder working { folder / "" };
    OpenedWindow window { tests::cornell, tests::reference };
    window.showOnly("save");
    CameraConfig& camera = window.application.document().settings.config.camera;
    const CameraConfig saved { { 0.1f, 0.2f, 0.3f }, { 10.0f, 1.0f / 3.0f, 30.0f }, 2.5f, 40.0f };
    const auto isSaved = [&](const CameraConfig& c) {
        return c.lookAt == saved.lookAt && c.rotation == saved.rotation
            && c.distanceFromLookAt == saved.distanceFromLookAt && c.fieldOfView == saved.fieldOfView;
    };
    window.enter("name", "mine");
    camera = saved;
    window.activate("save camera");
    CHECK(isSaved(files::loadCamera(folder / "mine.camera.toml")));
    camera = {};
    window.activate("load camera");
    CHECK(isSaved(camera));
    camera = {};
    window.drop(folder / "mine.camera.toml");
    CHECK(isSaved(camera));
    CHECK(window.application.document().path() == tests::cornell);
    CHECK(window.application.message().empty());
}

TEST_CASE("A camera file that is bad is a message, and the camera stays", "[window]")
{
    const files_test::TemporaryFolder folder;
    const WorkingFolder working { folder / "" };
    OpenedWindow window { tests::cornell, tests::reference };
    window.showOnly("save");
    const glm::vec3 rotation = window.application.document().settings.config.camera.rotation;
    window.activate("load camera");
    CHECK_THAT(window.application.saved(), Contains("saved.camera.toml: cannot be read"));
    folder.write("saved.camera.toml", "[camera]\nrotation = [1, 2, 3]\ndistance = -1\n");
    window.activate("load camera");
    CHECK_THAT(window.application.saved(), Contains("saved.camera.toml:3: found -1"));
    CHECK(window.application.document().settings.config.camera.rotation == rotation);
}
