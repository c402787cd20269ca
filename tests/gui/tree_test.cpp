#include "changed_reference.h"
#include "files/text.h"
#include "opened_window.h"
#include <catch2/catch.hpp>

// A level and a leaf of the tree in the window, in the Cornell box unless it is said otherwise.

using tests::OpenedWindow;

namespace {

void openTree(OpenedWindow& window)
{
    window.drawUntil([&] { return window.application.tree().drawing().numLevels > 0; });
    window.showOnly("tree");
}

std::size_t numDrawn(const OpenedWindow& window)
{
    return window.application.tree().drawing().shapes.size();
}

template <typename Kind> std::size_t countDrawn(const OpenedWindow& window)
{
    return static_cast<std::size_t>(std::ranges::count_if(window.application.tree().drawing().shapes,
        [](const debug::Shape& shape) { return std::holds_alternative<Kind>(shape.drawn); }));
}

AxisAlignedBox boundsOf(const Scene& scene)
{
    AxisAlignedBox box { glm::vec3(FLT_MAX), glm::vec3(-FLT_MAX) };
    for (const Mesh& mesh : scene.meshes)
        for (const Vertex& vertex : mesh.vertices) {
            box.lower = glm::min(box.lower, vertex.position);
            box.upper = glm::max(box.upper, vertex.position);
        }
    return box;
}

}

TEST_CASE("Of the tree nothing is drawn but what is switched on", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    openTree(window);
    CHECK(numDrawn(window) == 0);
    window.activate("level");
    window.drawUntil([&] { return numDrawn(window) == 1; });
    window.activate("leaf");
    window.drawUntil([&] { return numDrawn(window) > 1; });
    window.activate("level");
    window.activate("leaf");
    window.drawUntil([&] { return numDrawn(window) == 0; });
}

TEST_CASE("Level 0 is the box of the scene, and each level has its boxes, over the picture", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    window.drawUntilTraced();
    openTree(window);
    const auto before = window.screenshot();
    window.activate("level");
    window.drawUntil([&] { return numDrawn(window) == 1; });
    const auto& root = std::get<debug::DrawnBox>(window.application.tree().drawing().shapes.front().drawn);
    const AxisAlignedBox bounds = boundsOf(window.application.document().scene());
    CHECK(root.box.lower == bounds.lower);
    CHECK(root.box.upper == bounds.upper);
    const auto after = window.screenshot();
    std::size_t numChanged = 0;
    for (int y = 0; y < before.size.y; ++y)
        for (int x = 360; x < before.size.x; ++x) { // right of the panel
            const auto i = static_cast<std::size_t>(y * before.size.x + x);
            numChanged += before.pixels[i] != after.pixels[i];
        }
    CHECK(numChanged > 1000); // twelve edges, some hundred pixels each

    const auto numLevels = static_cast<int>(window.application.tree().drawing().numLevels);
    for (int level = 1; level < numLevels; ++level) {
        window.enter("##which level", std::to_string(level));
        CHECK(window.application.tree().wanted().level == level);
    }
    window.drawUntil([&] { return numDrawn(window) != 1; });
    window.enter("##which level", "1");
    window.drawUntil([&] { return numDrawn(window) == 2; });
    window.enter("##which level", "1000000");
    CHECK(window.application.tree().wanted().level == numLevels - 1);
}

TEST_CASE("A leaf is drawn with its box and its few triangles, and there is none beyond the last", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    openTree(window);
    window.activate("leaf");
    const auto numLeaves = static_cast<int>(window.application.tree().drawing().numLeaves);
    window.enter("##which leaf", "1000000");
    CHECK(window.application.tree().wanted().leaf == numLeaves);
    window.drawUntil([&] { return numDrawn(window) > 0; });
    window.enter("##which leaf", "-7");
    CHECK(window.application.tree().wanted().leaf == 1);
    window.drawUntil([&] { return countDrawn<debug::DrawnTriangle>(window) > 0; });
    CHECK(countDrawn<debug::DrawnBox>(window) == 1);
    CHECK(countDrawn<debug::DrawnTriangle>(window) <= 4);
}

TEST_CASE("A submission's own drawing of its tree is shown, and switching off one that fails brings the picture back",
    "[window]")
{
    const std::string text = files::readText(tests::reference / "bvh.cpp");
    const tests::ChangedReference folder { "bvh.cpp", text + R"(
#include "draw.h"
void BVH::debugDrawLevel(int level)
{
    if (level == 1)
        *static_cast<volatile int*>(nullptr) = 0;
    drawSphere(glm::vec3(0.0f), 0.5f, glm::vec3(1.0f, 0.0f, 0.0f));
}
)" };
    OpenedWindow window { tests::cornell, folder.path() };
    openTree(window);
    window.activate("level");
    window.drawUntil([&] { return countDrawn<debug::DrawnSphere>(window) == 1; });
    window.enter("##which level", "1");
    window.drawUntil([&] { return window.application.message().find("Segmentation fault") != std::string::npos; });
    window.activate("level");
    window.drawUntil([&] { return window.application.isPictureDone() && window.application.message().empty(); });
}

TEST_CASE("Another scene has its own tree", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    openTree(window);
    window.activate("level");
    window.enter("##which level", "3");
    window.drawUntil([&] { return numDrawn(window) > 1; });
    window.drop(tests::source / "scenes" / "single_triangle.toml");
    window.drawUntil([&] { return window.application.tree().drawing().numLevels == 1; });
    CHECK(window.application.tree().drawing().numLeaves == 1);
    window.drawUntil([&] { return numDrawn(window) == 1; });
}
