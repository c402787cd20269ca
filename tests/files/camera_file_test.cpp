#include "files/camera_file.h"
#include "files/error.h"
#include "files/scene_file.h"
#include "files/text.h"
#include "temporary_folder.h"
#include <catch2/catch.hpp>

using Catch::Matchers::Contains;
using files_test::TemporaryFolder;

namespace {

const CameraConfig someCamera { .lookAt = { 0.1f, -0.0f, 1e-30f },
    .rotation = { 1.0f / 3.0f, -720.0f, 16777217.0f },
    .distanceFromLookAt = std::nextafter(2.7f, 3.0f),
    .fieldOfView = 179.999f };

void checkSame(const CameraConfig& a, const CameraConfig& b)
{
    CHECK(a.lookAt == b.lookAt);
    CHECK(a.rotation == b.rotation);
    CHECK(a.distanceFromLookAt == b.distanceFromLookAt);
    CHECK(a.fieldOfView == b.fieldOfView);
}

}

TEST_CASE("A camera that is saved is read back to the last bit, also as a scene's", "[files]")
{
    const TemporaryFolder folder;
    files::saveCamera(folder / "a.toml", someCamera);
    checkSame(files::loadCamera(folder / "a.toml"), someCamera);
    checkSame(files::loadSceneFile(folder / "a.toml").config.camera, someCamera);
}

TEST_CASE("A camera file has a camera and nothing else", "[files]")
{
    const TemporaryFolder folder;
    const auto isCameraFile
        = [&](const std::string& text) { return files::isCameraFile(folder.write("a.toml", text)); };
    CHECK(isCameraFile("[camera]\ndistance = 3\n"));
    CHECK_FALSE(isCameraFile(""));
    CHECK_FALSE(isCameraFile("size = [7, 7]\n[camera]\ndistance = 3\n"));
    CHECK_FALSE(files::isCameraFile(folder.write("a.obj", "v 0 0 0\n")));
}

TEST_CASE("Of a scene file the camera alone can be read, with what it leaves out as in a scene", "[files]")
{
    const TemporaryFolder folder;
    const auto path = folder.write("a.toml", "size = [7, 7]\n[camera]\ndistance = 3\n");
    checkSame(files::loadCamera(path), { .distanceFromLookAt = 3.0f });
}

TEST_CASE("A file without a camera, or with a bad one, is an error that says where", "[files]")
{
    const TemporaryFolder folder;
    const auto [text, message] = GENERATE(table<std::string, std::string>({
        { "size = [7, 7]\n", "a.toml:1: found no [camera], expected one" },
        { "[camera]\ndistance = -3\n", "a.toml:2: found -3, expected a number of at least 0" },
        { "[camera]\nfar = 3\n", "a.toml:2: found the unknown key \"far\"" },
        { "camera = 3\n", "a.toml:1: found 3" },
        { "[camera\n", "a.toml:1: " },
    }));
    const auto path = folder.write("a.toml", text);
    CHECK_THROWS_AS(files::loadCamera(path), files::Error);
    CHECK_THROWS_WITH(files::loadCamera(path), Contains(message));
    CHECK_THROWS_WITH(files::loadCamera(folder / "none.toml"), Contains("none.toml: cannot be read"));
}

TEST_CASE("A camera that could not be read back is not written", "[files]")
{
    const TemporaryFolder folder;
    const auto path = folder.write("a.toml", "kept");
    CHECK_THROWS_WITH(files::saveCamera(path, { .fieldOfView = 180.0f }),
        Contains("a.toml: not written") && Contains("found 180, expected an angle between 0 and 180 degrees"));
    CHECK(files::readText(path) == "kept");
    CHECK_THROWS_WITH(files::saveCamera(folder / "no/b.toml", {}), Contains("b.toml: cannot be written"));
}
