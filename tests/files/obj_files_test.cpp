#include "files/scene_file.h"
#include "temporary_folder.h"
#include <catch2/catch.hpp>

using Catch::Matchers::Contains;
using files_test::TemporaryFolder;

TEST_CASE("Many files are read side by side and stay in the order in which they are named", "[files]")
{
    const TemporaryFolder folder;
    std::string text;
    for (int i = 0; i < 40; ++i) {
        const std::string name = std::to_string(i) + ".obj", x = std::to_string(i);
        folder.write(name, "v " + x + " 0 0\nv 100 0 0\nv 100 1 0\nf 1 2 3\n");
        text += "[[mesh]]\nfile = \"" + name + "\"\nnormalize = false\n";
    }
    const Scene scene = files::loadSceneFile(folder.write("a.toml", text)).scene;
    REQUIRE(scene.meshes.size() == 40);
    for (std::size_t i = 0; i < 40; ++i)
        CHECK(scene.meshes[i].vertices[0].position.x == static_cast<float>(i));

    folder.write("30.obj", "f 1 2 3\n"); // both are wrong: the first that is named is told
    folder.write("20.obj", "f 1 2 3\n");
    CHECK_THROWS_WITH(files::loadSceneFile(folder / "a.toml"), Contains("a.toml:62: ") && Contains("20.obj:1: "));
}
