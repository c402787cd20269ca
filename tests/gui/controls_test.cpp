#include "changed_reference.h"
#include "files/feature_settings.h"
#include "opened_window.h"
#include <catch2/catch.hpp>

// Every control of the side panel is operated, and does what its name says. Those of files, of the tree and of a
// followed ray have tests of their own.

using tests::Control;
using tests::OpenedWindow;

namespace {

// Types a number into each component of a vector, and expects it there.
void checkVector(OpenedWindow& window, Control control, glm::vec3& value, const std::vector<std::string>& components)
{
    const glm::vec3 target { 0.25f, 0.5f, 0.75f };
    for (int i = 0; i < 3; ++i) {
        Control component = control;
        if (components.empty()) // as DragFloat3 has them
            component.path.emplace_back(i);
        component.path.emplace_back(components.empty() ? "" : components[static_cast<std::size_t>(i)]);
        window.enter(component, std::to_string(target[i]));
    }
    CHECK(value == target);
}

void checkPlace(OpenedWindow& window, const Control& control, glm::vec3& value)
{
    checkVector(window, control, value, {});
}

void checkColor(OpenedWindow& window, const Control& control, glm::vec3& value)
{
    checkVector(window, control, value, { "##X", "##Y", "##Z" });
}

}

TEST_CASE("Every count of a feature takes what is typed, within its bounds", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    window.showOnly("features");
    Features& features = window.application.document().settings.config.features;
    std::size_t numCounts = 0;
    for (const std::string& name : files::featureNames()) {
        if (!std::holds_alternative<int64_t>(files::featureValue(features, name)))
            continue;
        INFO(name);
        ++numCounts;
        const auto [least, most] = files::countRange(name);
        for (const int64_t typed : { 5, 7, 0, -5 }) {
            window.enter(name, std::to_string(typed));
            CHECK(files::featureValue(features, name) == files::FeatureValue(std::clamp(typed, least, most)));
        }
    }
    CHECK(numCounts >= 2);
}

TEST_CASE("Every shading model can be chosen", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    window.showOnly("features");
    const Features& features = window.application.document().settings.config.features;
    for (const std::string& model : files::shadingModelNames()) {
        window.choose("shading_model", model);
        CHECK(files::featureValue(features, "shading_model") == files::FeatureValue(model));
    }
    window.drawUntilTraced();
    CHECK(window.application.message().empty());
}

TEST_CASE("Every number of the camera can be typed, and undone", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    window.showOnly("camera");
    CameraConfig& camera = window.application.document().settings.config.camera;
    const CameraConfig before = camera;
    checkPlace(window, "look at", camera.lookAt);
    checkPlace(window, "rotation", camera.rotation);
    window.enter("distance", "2.5");
    CHECK(camera.distanceFromLookAt == 2.5f);
    window.enter("field of view", "30");
    CHECK(camera.fieldOfView == 30.0f);
    for (int i = 0; i < 8; ++i)
        window.pressKey("ctrl+z");
    CHECK(camera.lookAt == before.lookAt);
    CHECK(camera.rotation == before.rotation);
    CHECK(camera.distanceFromLookAt == before.distanceFromLookAt);
    CHECK(camera.fieldOfView == before.fieldOfView);
}

TEST_CASE("Every place and colour of each kind of light can be typed", "[window]")
{
    OpenedWindow window { tests::source / "scenes" / "cube.toml", tests::reference };
    auto& lights = window.application.document().settings.lights;
    lights = { PointLight {}, SegmentLight {}, ParallelogramLight {} };
    window.showOnly("lights");
    auto& point = std::get<PointLight>(lights[0]);
    checkPlace(window, { { 0, "position" } }, point.position);
    checkColor(window, { { 0, "color" } }, point.color);
    auto& segment = std::get<SegmentLight>(lights[1]);
    checkPlace(window, { { 1, "endpoint0" } }, segment.endpoint0);
    checkPlace(window, { { 1, "endpoint1" } }, segment.endpoint1);
    checkColor(window, { { 1, "color0" } }, segment.color0);
    checkColor(window, { { 1, "color1" } }, segment.color1);
    auto& parallelogram = std::get<ParallelogramLight>(lights[2]);
    checkPlace(window, { { 2, "v0" } }, parallelogram.v0);
    checkPlace(window, { { 2, "edge01" } }, parallelogram.edge01);
    checkPlace(window, { { 2, "edge02" } }, parallelogram.edge02);
    checkColor(window, { { 2, "color0" } }, parallelogram.color0);
    checkColor(window, { { 2, "color1" } }, parallelogram.color1);
    checkColor(window, { { 2, "color2" } }, parallelogram.color2);
    checkColor(window, { { 2, "color3" } }, parallelogram.color3);
}

TEST_CASE("A light's handle is shown by its switch, and a light is moved by it", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    window.drawUntilTraced();
    window.showOnly("lights");
    const auto& light = std::get<PointLight>(window.application.document().settings.lights.front());
    const glm::vec3 before = light.position;
    const debug::Projection projection { window.camera(), window.application.picture().size };
    const glm::ivec2 handle = window.toWindow(projection.point(before).value());
    const glm::vec3 rotation = window.application.document().settings.config.camera.rotation;
    window.activate("light handles");
    window.dragMouse(handle, handle + glm::ivec2(60, 30));
    CHECK(light.position != before);
    CHECK(window.application.document().settings.config.camera.rotation == rotation);
    const glm::vec3 moved = light.position;
    window.activate("light handles");
    window.dragMouse(handle + glm::ivec2(60, 30), handle);
    CHECK(light.position == moved);
    CHECK(window.application.document().settings.config.camera.rotation != rotation);
}

TEST_CASE("Rasterised and traced, wireframe and filled are switched by their buttons and by T", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    window.drawUntilTraced();
    const auto isAnother = [](const gui::Picture& a, const gui::Picture& b) {
        std::size_t numOther = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i)
            numOther += static_cast<int>(i) % a.size.x > 360 && a.pixels[i] != b.pixels[i]; // right of the panel
        return numOther > 10'000;
    };
    const gui::Picture traced = window.screenshot();
    window.activate("rasterised");
    const gui::Picture rasterised = window.screenshot();
    CHECK(isAnother(traced, rasterised));
    window.activate("wireframe");
    CHECK(isAnother(rasterised, window.screenshot()));
    window.activate("wireframe");
    CHECK_FALSE(isAnother(rasterised, window.screenshot()));
    window.activate("traced");
    CHECK_FALSE(isAnother(traced, window.screenshot()));
    window.pressKey("t");
    window.drawFrames(1);
    CHECK_FALSE(isAnother(rasterised, window.screenshot()));
}
