#include "changed_reference.h"
#include "files/bitmap.h"
#include "files/picture.h"
#include "opened_window.h"
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>

// What the window shows, against pictures that were looked at and kept. RAYWORK_KEEP=1 in the environment keeps what is
// shown now in their place.

namespace fs = std::filesystem;
using tests::source;

namespace {

std::vector<std::string> sceneNames()
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(source / "scenes"))
        if (entry.path().extension() == ".toml")
            names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

// The profiler's strip along the bottom tells of times.
gui::Picture withoutFigures(gui::Picture picture)
{
    const int height = 36 * (picture.size.x / 1280);
    std::fill_n(picture.pixels.begin(), height * picture.size.x, glm::vec3(0.0f));
    return picture;
}

// A quarter of the width and height, so that a kept picture is small and one pixel more or less of an edge is little.
gui::Picture reduced(const gui::Picture& picture)
{
    constexpr int factor = 4;
    gui::Picture small;
    small.size = picture.size / factor;
    for (int y = 0; y < small.size.y; ++y)
        for (int x = 0; x < small.size.x; ++x) {
            glm::vec3 sum { 0.0f };
            for (int i = 0; i < factor * factor; ++i)
                sum += picture.pixels[static_cast<std::size_t>(
                    (y * factor + i / factor) * picture.size.x + x * factor + i % factor)];
            small.pixels.push_back(sum / static_cast<float>(factor * factor));
        }
    return small;
}

struct Difference {
    float mean = 0.0f, worst = 0.0f; // of all channels; of the pixel that differs most
};

Difference differenceOf(const gui::Picture& shown, const Image& kept)
{
    REQUIRE(glm::ivec2(kept.width, kept.height) == shown.size);
    Difference difference;
    for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
        const glm::vec3 d = glm::abs(shown.pixels[i] - kept.get_pixel(static_cast<int>(i)));
        difference.mean += (d.x + d.y + d.z) / (3.0f * static_cast<float>(shown.pixels.size()));
        difference.worst = std::max({ difference.worst, d.x, d.y, d.z });
    }
    return difference;
}

void compareWithKept(tests::OpenedWindow& window, const std::string& name)
{
    const gui::Picture shown = reduced(withoutFigures(window.screenshot()));
    const fs::path path = source / "tests" / "gui" / "kept" / (name + ".png");
    if (std::getenv("RAYWORK_KEEP")) {
        const std::vector<std::byte> png = files::encodePng(shown.size, shown.pixels);
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    }
    const Difference difference = differenceOf(shown, *files::loadPicture(path));
    INFO(name);
    // Eight bits round by 0.002; a letter, a line or an edge elsewhere is a pixel that differs by more than half.
    CHECK(difference.mean < 0.004f);
    CHECK(difference.worst < 0.5f);
}

}

TEST_CASE("Every scene looks like its kept picture", "[window]")
{
    const std::string name = GENERATE(from_range(sceneNames()));
    tests::OpenedWindow window { source / "scenes" / (name + ".toml"), source / "reference" };
    window.drawUntilTraced();
    compareWithKept(window, name);
}

TEST_CASE("A followed ray and the page of help look like their kept pictures", "[window]")
{
    tests::OpenedWindow window { source / "scenes" / "cornell_box.toml", source / "reference" };
    window.drawUntilTraced();
    window.moveMouse({ 800, 430 });
    window.pressKey("r");
    window.drawUntil([&] { return window.application.ray().isShowing(); });
    window.pressKey("question");
    window.moveMouse({ 1, 1 });
    window.drawFrames(3);
    compareWithKept(window, "ray_and_help");
}

TEST_CASE("False colours and their legend look like their kept pictures", "[window]")
{
    struct Shown {
        std::string scene, quantity;
    };
    const Shown shown
        = GENERATE(values<Shown>({ { "cornell_box", "normal" }, { "monkey", "nodes_visited" }, { "spheres", "t" } }));
    tests::OpenedWindow window { source / "scenes" / (shown.scene + ".toml"), source / "reference" };
    window.choose("shows", shown.quantity);
    window.drawUntilTraced();
    window.moveMouse({ 820, 300 });
    compareWithKept(window, shown.scene + "_" + shown.quantity);
}

TEST_CASE("A level and a leaf of the tree, and handles of lights, look like their kept picture, also on a dense screen",
    "[window]")
{
    const int density = GENERATE(1, 2);
    tests::OpenedWindow window { source / "scenes" / "cube.toml", tests::reference, density };
    window.drawUntilTraced();
    window.showOnly("lights");
    window.activate("light handles");
    window.showOnly("tree");
    window.activate("level");
    window.activate("leaf");
    window.enter("##which level", "1");
    window.drawUntil([&] { return window.application.tree().drawing().shapes.size() > 3; });
    window.drawFrames(2);
    compareWithKept(window, density == 1 ? "tree" : "tree_dense");
}

// Against the same limits, and against the traced picture by what is background in the one and not in the other.
TEST_CASE("The rasterised view shows a scene where the traced one does", "[window]")
{
    const std::string name = GENERATE("teapot", "monkey");
    tests::OpenedWindow window { source / "scenes" / (name + ".toml"), source / "reference" };
    Features& features = window.application.document().settings.config.features;
    features.enableShading = features.enableShadows = false; // nothing is as dark as the background
    window.drawUntilTraced();
    const gui::Picture traced = window.screenshot();
    window.pressKey("t");
    window.drawFrames(2);
    compareWithKept(window, name + "_rasterised");
    const gui::Picture rasterised = window.screenshot();
    const auto isBackground = [](const glm::vec3& color) { return color == glm::vec3(0.0f); };
    std::size_t numTraced = 0, numOther = 0;
    for (int y = 0; y < traced.size.y; ++y)
        for (int x = 380; x < traced.size.x; ++x) { // right of the panel
            const auto i = static_cast<std::size_t>(y * traced.size.x + x);
            numTraced += !isBackground(traced.pixels[i]);
            numOther += isBackground(traced.pixels[i]) != isBackground(rasterised.pixels[i]);
        }
    CHECK(numTraced > 10'000);
    CHECK(numOther < numTraced / 500); // where a sample lies on an edge
}
