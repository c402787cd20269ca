#include "files/error.h"
#include "files/scene_writer.h"
#include "files/text.h"
#include "temporary_folder.h"
#include <catch2/catch.hpp>

using Catch::Matchers::Contains;
using files::saveScene;
using files_test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

// What lies in it, folders and hidden files too.
std::size_t countEntries(const fs::path& folder)
{
    return static_cast<std::size_t>(std::distance(fs::recursive_directory_iterator(folder), {}));
}

}

TEST_CASE("A scene that cannot be written is an error and leaves nothing", "[files]")
{
    const TemporaryFolder folder;
    const fs::path path = folder.write("a.toml", "");
    fs::create_directories(folder / "taken.toml/full");
    const auto [name, message] = GENERATE(table<std::string, std::string>({
        { "nowhere/b.toml", "b.toml: cannot be written: No such file or directory" },
        { "a.toml/b.toml", "b.toml: cannot be written: Not a directory" },
        { "taken.toml", "taken.toml: cannot be written: Is a directory" },
        { "b.obj", "b.obj: found the extension \".obj\", expected a scene in .toml" },
        { "b", "b: found the extension \"\", expected a scene in .toml" },
    }));
    const std::size_t before = countEntries(folder / "");
    CHECK_THROWS_AS(saveScene(folder / name, path, Config {}, {}), files::Error);
    CHECK_THROWS_WITH(saveScene(folder / name, path, Config {}, {}), Contains(message));
    CHECK(countEntries(folder / "") == before);
}

TEST_CASE("A scene that could not be read back is not written", "[files]")
{
    const TemporaryFolder folder;
    const fs::path path = folder.write("a.toml", "size = [7, 7]\n");
    Config config;
    std::vector<Scene::SceneLight> lights;
    std::string found;
    SECTION("for its camera")
    {
        config.camera.fieldOfView = 180.0f;
        found = "found 180, expected an angle between 0 and 180 degrees";
    }
    SECTION("for its size")
    {
        config.size = { 0, 800 };
        found = "found 0, expected integers from 1 to 32768";
    }
    SECTION("for its features")
    {
        config.features.numShadowSamples = 0;
        found = "shadow_samples: found 0, expected a count from 1 to 1048576";
    }
    SECTION("for a light")
    {
        lights = { PointLight { glm::vec3(0.0f), { 1.0f, -1.0f, 1.0f } } };
        found = "found -1, expected a number of at least 0";
    }
    SECTION("for a number that is none")
    {
        lights = { PointLight { glm::vec3(std::numeric_limits<float>::quiet_NaN()), glm::vec3(1.0f) } };
        found = "found nan, expected a number";
    }
    CHECK_THROWS_WITH(saveScene(path, path, config, lights), Contains("a.toml: not written") && Contains(found));
    CHECK(files::readText(path) == "size = [7, 7]\n");
    CHECK(countEntries(folder / "") == 1);
}

TEST_CASE("A scene whose original is gone is not written", "[files]")
{
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(
        saveScene(folder / "b.toml", folder / "a.toml", Config {}, {}), Contains("a.toml: cannot be read"));
    CHECK(countEntries(folder / "") == 0);
}
