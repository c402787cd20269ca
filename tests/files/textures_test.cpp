#include "bvh.h"
#include "files/error.h"
#include "files/picture.h"
#include "files/scene_file.h"
#include "screen.h"
#include "temporary_folder.h"
#include <catch2/catch.hpp>
#include <fmt/core.h>
#include <framework/trackball.h>
#include <thread>

using files_test::TemporaryFolder;

namespace {

auto numFetched(const Scene& scene)
{
    return std::ranges::count_if(scene.textures, [](const auto& texture) { return texture->pixels.areFetched(); });
}

// Squares in a row, each with a texture of its own; the camera is before the first three.
std::string rowOfPictures(const TemporaryFolder& folder, int number)
{
    std::string scene = "[features]\ntexture_mapping = true\nshading = true\n[[light]]\ntype = \"point\"\n"
                        "position = [1.5, 0.5, -5]\ncolor = [1, 1, 1]\n";
    for (int i = 0; i < number; ++i) {
        folder.write(fmt::format("{}.tga", i), files_test::tinyTga());
        scene += fmt::format("[[mesh]]\nquads = [[[{0}, 0, 0], [{0}, 1, 0], [{1}, 1, 0], [{1}, 0, 0]]]\n"
                             "texture = \"{0}.tga\"\n",
            i, i + 1);
    }
    return scene;
}

}

TEST_CASE("Of a thousand textures those three that the camera sees are decoded", "[files]")
{
    const TemporaryFolder folder;
    files::SceneFile file = files::loadSceneFile(folder.write("a.toml", rowOfPictures(folder, 1000)));
    REQUIRE(file.scene.textures.size() == 1000);
    CHECK(numFetched(file.scene) == 0);
    CHECK(file.scene.textures[999]->width == 2);
    CHECK(file.scene.textures[999]->pixels.size() == 4);

    file.config.size = { 64, 8 };
    const BVH bvh(file.scene, file.config.features);
    Screen screen(file.config.size);
    Trackball camera(0.3f, 1.0f, 8.0f);
    camera.setCamera({ 1.5f, 0.5f, 0.0f }, glm::vec3(0.0f), 1.2f); // sees 8 * 1.2 * tan(0.15) = 1.45 to each side
    renderImage(file.scene, bvh, file.config.features, camera, screen);
    CHECK(numFetched(file.scene) == 3);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(file.scene.textures[i]->pixels.areFetched());
}

TEST_CASE("Threads that look at a texture at once all see it", "[files]")
{
    const TemporaryFolder folder;
    const auto image = files::openPicture(folder.write("a.tga", files_test::tinyTga()));
    std::vector<std::jthread> threads;
    std::atomic<int> numRight = 0;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([&] { numRight += image->get_pixel(3) == glm::vec3(1.0f); });
    threads.clear();
    CHECK(numRight == 8);
}

TEST_CASE("A copy of an image that nobody has looked at is whole, and its own", "[files]")
{
    const TemporaryFolder folder;
    const auto image = files::openPicture(folder.write("a.tga", files_test::tinyTga()));
    Image copy = *image;
    CHECK(copy.get_pixel(0) == glm::vec3(1, 0, 0));
    copy.set_pixel(0, glm::vec3(0, 0, 1));
    CHECK(image->get_pixel(0) == glm::vec3(1, 0, 0));
    const Image moved = std::move(copy);
    CHECK(moved.get_pixel(0) == glm::vec3(0, 0, 1));
    CHECK(moved.pixels[3] == glm::vec3(1.0f));
}

TEST_CASE("A picture that ends too early is opened, and refused by name when somebody looks at it", "[files]")
{
    const TemporaryFolder folder;
    const auto image = files::openPicture(folder.write("cut.tga", files_test::tinyTga().substr(0, 25)));
    CHECK(image->height == 2);
    for (int i = 0; i < 2; ++i) // the second time, too
        CHECK_THROWS_WITH((void)image->get_pixel(0), Catch::Contains("cut.tga: found the end of the file"));
    CHECK_THROWS_AS(files::openPicture(folder / "none.png"), files::Error);
}
