#include "changed_reference.h"
#include "files/feature_settings.h"
#include "files/picture.h"
#include "gui/layout_file.h"
#include "opened_window.h"
#include <catch2/catch.hpp>
#include <fstream>
#include <glm/gtx/component_wise.hpp>
#include <imgui_internal.h>

// The real window, on a real screen that nobody sees.

namespace fs = std::filesystem;
using tests::cornell;
using tests::OpenedWindow;
using tests::reference;

namespace {

const Features& featuresOf(const OpenedWindow& window)
{
    return window.application.document().settings.config.features;
}

const CameraConfig& cameraOf(const OpenedWindow& window)
{
    return window.application.document().settings.config.camera;
}

}

TEST_CASE("Every switch of a feature can be pressed, and does what its name says", "[window]")
{
    OpenedWindow window { cornell, reference };
    window.showOnly("features");
    for (const std::string& name : files::featureNames()) {
        const files::FeatureValue before = files::featureValue(featuresOf(window), name);
        if (!std::holds_alternative<bool>(before))
            continue;
        INFO(name);
        window.activate(name.c_str());
        CHECK(files::featureValue(featuresOf(window), name) == files::FeatureValue(!std::get<bool>(before)));
        window.pressKey("ctrl+z");
        CHECK(files::featureValue(featuresOf(window), name) == before);
        window.pressKey("ctrl+y");
        CHECK(files::featureValue(featuresOf(window), name) != before);
        window.pressKey("ctrl+z");
    }
    window.drawUntilTraced();
    CHECK(window.application.message().empty());
}

TEST_CASE("Lights of the three kinds are added and removed", "[window]")
{
    OpenedWindow window { cornell, reference };
    const auto& lights = window.application.document().settings.lights;
    const std::size_t before = lights.size();
    window.activate("features"); // closes the section, so that the next ones come into sight
    window.activate("lights");
    window.activate("add point");
    window.activate("add segment");
    window.activate("add parallelogram");
    REQUIRE(lights.size() == before + 3);
    CHECK(std::holds_alternative<PointLight>(lights[before]));
    CHECK(std::holds_alternative<SegmentLight>(lights[before + 1]));
    CHECK(std::holds_alternative<ParallelogramLight>(lights[before + 2]));
    window.activate({ { static_cast<int>(before) + 1, "remove" } });
    REQUIRE(lights.size() == before + 2);
    CHECK(std::holds_alternative<ParallelogramLight>(lights[before + 1]));
    window.drawUntilTraced();
}

TEST_CASE("The mouse turns, moves and approaches, and a click alone does nothing", "[window]")
{
    OpenedWindow window { cornell, reference };
    const CameraConfig before = cameraOf(window);
    window.dragMouse({ 800, 300 }, { 800, 300 });
    CHECK(cameraOf(window).rotation == before.rotation);
    window.dragMouse({ 800, 300 }, { 900, 300 });
    CHECK(cameraOf(window).rotation.y != before.rotation.y);
    CHECK(cameraOf(window).lookAt == before.lookAt);
    window.dragMouse({ 800, 300 }, { 820, 340 }, 3);
    CHECK(cameraOf(window).lookAt != before.lookAt);
    window.drawUntilTraced();
}

TEST_CASE("R follows the ray under the mouse, and Escape forgets it", "[window]")
{
    OpenedWindow window { cornell, reference };
    window.drawUntilTraced();
    window.moveMouse({ 800, 430 });
    window.pressKey("r");
    window.drawUntil([&] { return window.application.ray().isShowing(); });
    const std::size_t all = window.application.ray().numShown();
    CHECK(all > 10);
    window.activate("features"); // closes the section, so that the next ones come into sight
    window.activate("boxes");
    CHECK(window.application.ray().numShown() < all);
    window.pressKey("Escape");
    CHECK_FALSE(window.application.ray().isShowing());
}

TEST_CASE("A key that is let go before the next frame is heard", "[window]")
{
    OpenedWindow window { cornell, reference };
    window.drawUntilTraced();
    const Features before = featuresOf(window);
    window.showOnly("features");
    window.activate("shading");
    REQUIRE(featuresOf(window).enableShading != before.enableShading);
    window.tapKey("ctrl+z");
    window.drawUntil([&] { return featuresOf(window).enableShading == before.enableShading; });
}

TEST_CASE("A panel that is moved stands there the next time, too", "[window]")
{
    const files_test::TemporaryFolder settings;
    setenv("XDG_CONFIG_HOME", (settings / "").c_str(), 1);
    const std::string layout = gui::layoutFile();
    unsetenv("XDG_CONFIG_HOME");
    const auto placeOfHelp = [](OpenedWindow& window) {
        window.pressKey("question");
        window.drawFrames(2);
        const ImVec2 place = ImGui::FindWindowByName("help")->Pos;
        return glm::ivec2(place.x, place.y);
    };
    glm::ivec2 before, moved { 130, 70 };
    {
        OpenedWindow window { cornell, reference, 1, layout };
        before = placeOfHelp(window);
        window.dragMouse(before + 8, before + 8 + moved);
    }
    OpenedWindow again { cornell, reference, 1, layout };
    CHECK(placeOfHelp(again) == before + moved);
}

TEST_CASE("Each quantity can be chosen by its name, by F, and colours come back as they were", "[window]")
{
    OpenedWindow window { cornell, reference };
    window.drawUntilTraced();
    const gui::Picture before = window.application.picture();
    std::vector<std::vector<glm::vec3>> chosen;
    for (const debug::Quantity quantity : debug::allQuantities()) {
        INFO(debug::nameOf(quantity));
        window.choose("shows", debug::nameOf(quantity));
        window.drawUntilTraced();
        CHECK(window.application.picture().quantity == quantity);
        CHECK(std::ranges::count(chosen, window.application.picture().pixels) == 0);
        chosen.push_back(window.application.picture().pixels);
    }
    window.choose("shows", "color");
    window.drawUntilTraced();
    CHECK(window.application.picture().pixels == before.pixels);
    for (std::size_t i = 1; i <= chosen.size(); ++i) {
        window.pressKey("f");
        window.drawUntilTraced();
        CHECK(window.application.picture().pixels == chosen[i % chosen.size()]);
    }
    CHECK(window.application.message().empty());
}

TEST_CASE("A submission that fails is reported, and replaced by a good one while the window lives on", "[window]")
{
    struct Failure {
        std::string text, message;
    };
    const Failure failure = GENERATE(values<Failure>({
        { "#include \"light.h\"\nthis does not compile\n", "light.cpp is left out" },
        { "#include \"light.h\"\nglm::vec3 computeContributionPointLight(RenderState&, const PointLight&, const Ray&, "
          "const HitInfo&) { return *static_cast<volatile float*>(nullptr) * glm::vec3(1.0f); }\n",
            "Segmentation fault" },
        { "#include \"light.h\"\nglm::vec3 computeContributionPointLight(RenderState&, const PointLight&, const Ray&, "
          "const HitInfo&) { for (volatile bool forever = true; forever;) { } return {}; }\n",
            "no answer in time" },
    }));
    const tests::ChangedReference folder { "light.cpp", failure.text };
    OpenedWindow window { cornell, folder.path() };
    window.drawUntil([&] { return window.application.message().find(failure.message) != std::string::npos; });
    folder.repair();
    window.drawUntil([&] { return window.application.isPictureDone() && window.application.message().empty(); });
}

TEST_CASE("A scene that is saved is rendered as the window shows it", "[window]")
{
    const files_test::TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder / "");
    gui::Picture shown;
    {
        OpenedWindow window { cornell, reference };
        window.dragMouse({ 800, 300 }, { 860, 330 });
        window.activate("features");
        window.activate("lights");
        window.activate("add point");
        window.activate("lights");
        window.activate("save");
        window.drawUntilTraced();
        window.activate("save scene");
        window.activate("save picture");
        shown = window.application.picture();
    }
    fs::current_path(before);

    OpenedWindow again { folder / "saved.toml", reference };
    again.drawUntilTraced();
    CHECK(again.application.picture().size == shown.size);
    CHECK(again.application.picture().pixels == shown.pixels);
    const auto saved = files::loadPicture(folder / "saved.png");
    REQUIRE(saved->width == shown.size.x);
    REQUIRE(saved->height == shown.size.y);
    float largest = 0.0f;
    for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
        const glm::vec3 color = glm::clamp(shown.pixels[i], 0.0f, 1.0f);
        largest = std::max(largest, glm::compMax(glm::abs(color - saved->get_pixel(static_cast<int>(i)))));
    }
    CHECK(largest <= 0.5f / 255.0f + 1e-6f); // half a step of eight bits, and rounding
}
