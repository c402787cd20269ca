#include "app/debug_ray_json.h"
#include "changed_reference.h"
#include "files/text.h"
#include "gui/stroke_at.h"
#include "opened_window.h"
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <imgui_internal.h>
#include <set>

// A followed ray: in the picture, in its list, and as `render --debug-ray` writes it.

using tests::OpenedWindow;

namespace {

void follow(OpenedWindow& window, glm::ivec2 mouse)
{
    window.drawUntilTraced();
    window.moveMouse(mouse);
    window.pressKey("r");
    window.drawUntil([&] { return window.application.ray().isShowing(); });
}

std::vector<debug::Stroke> strokesOf(const OpenedWindow& window)
{
    return window.application.ray().strokes(window.camera(), window.application.picture().size);
}

struct Place {
    std::size_t shape;
    glm::vec2 place; // in the picture
};

// The middle of a line that no other line crosses nearby, as far down the list as can be.
Place placeOfLastLine(const OpenedWindow& window)
{
    const auto strokes = strokesOf(window);
    const glm::vec2 size = window.application.picture().size;
    std::optional<Place> found;
    for (const debug::Stroke& stroke : strokes) {
        const glm::vec2 middle = glm::floor((stroke.points.front() + stroke.points.back()) * 0.5f);
        const bool isInside
            = glm::all(glm::greaterThan(middle, glm::vec2(20.0f))) && glm::all(glm::lessThan(middle, size - 20.0f));
        std::vector<debug::Stroke> others = strokes;
        std::erase_if(others, [&](const debug::Stroke& other) { return other.shape == stroke.shape; });
        if (!stroke.isFilled && isInside && !gui::shapeAt(others, middle, 10.0f))
            found = { stroke.shape, middle };
    }
    REQUIRE(found);
    return *found;
}

// How much of what is drawn over the picture is as bright as that.
std::size_t countBright(const gui::Picture& screenshot)
{
    std::size_t count = 0;
    for (int y = 0; y < screenshot.size.y; ++y)
        for (int x = 360; x < screenshot.size.x; ++x) { // right of the panel
            const glm::vec3 color = screenshot.pixels[static_cast<std::size_t>(y * screenshot.size.x + x)];
            count += color.r > 0.95f && color.b < 0.1f; // from yellow to red, as boxes are
        }
    return count;
}

}

TEST_CASE("A click on a stroke selects it, scrolls the list to it and dims the others", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    follow(window, { 800, 430 });
    const gui::RayPanel& ray = window.application.ray();
    window.showOnly("ray");
    const auto [shape, place] = placeOfLastLine(window);
    const ImGuiWindow* const side = ImGui::FindWindowByName("side");
    CHECK(side->Scroll.y == 0.0f);
    window.moveMouse({ 370, 10 });
    const std::size_t bright = countBright(window.screenshot());
    const glm::ivec2 mouse = window.toWindow(place);
    window.dragMouse(mouse, mouse);
    CHECK(ray.selected() == shape);
    window.drawFrames(3);
    CHECK(side->Scroll.y > 0.0f);
    CHECK(countBright(window.screenshot()) < bright / 2);

    window.dragMouse({ 370, 10 }, { 370, 10 }); // where nothing is
    CHECK_FALSE(ray.selected());
    CHECK(countBright(window.screenshot()) == bright);
}

TEST_CASE("A click on a stroke opens the list that it selects it in", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    follow(window, { 800, 430 });
    window.showOnly("tree");
    const auto [shape, place] = placeOfLastLine(window);
    const glm::ivec2 mouse = window.toWindow(place);
    window.dragMouse(mouse, mouse);
    window.drawFrames(3);
    CHECK(window.application.ray().selected() == shape);
    CHECK(ImGui::FindWindowByName("side")->Scroll.y > 0.0f);
}

TEST_CASE("Dragging from a stroke turns the camera and selects nothing", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    follow(window, { 800, 430 });
    const glm::ivec2 mouse = window.toWindow(placeOfLastLine(window).place);
    const glm::vec3 before = window.application.document().settings.config.camera.rotation;
    window.dragMouse(mouse, mouse + glm::ivec2(40, 0));
    CHECK_FALSE(window.application.ray().selected());
    CHECK(window.application.document().settings.config.camera.rotation != before);
}

TEST_CASE("A click on a line of the list selects its shape, another one no shape", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    follow(window, { 800, 430 });
    window.showOnly("ray");
    window.dragMouse({ 100, 600 }, { 100, 600 });
    CHECK(window.application.ray().selected());
    window.dragMouse({ 100, 600 }, { 100, 600 });
    CHECK_FALSE(window.application.ray().selected());
}

TEST_CASE("The switches of the ray hide boxes and rays to lights, the slider boxes in the order visited", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    follow(window, { 800, 430 });
    window.showOnly("ray");
    const gui::RayPanel& ray = window.application.ray();
    const std::size_t all = ray.numShown();
    window.activate("shadow rays");
    const std::size_t onPath = ray.numShown();
    CHECK(onPath < all);
    window.activate("boxes");
    const std::size_t withoutBoxes = ray.numShown();
    CHECK(withoutBoxes < onPath);
    window.activate("boxes");
    window.enter("visited", "0");
    CHECK(ray.numShown() == withoutBoxes);
    window.enter("visited", "2");
    CHECK(ray.numShown() == withoutBoxes + 2);
    std::size_t numStroked = 0;
    for (const debug::Stroke& stroke : strokesOf(window))
        numStroked += std::holds_alternative<debug::DrawnBox>(ray.followed()->shapes[stroke.shape].drawn);
    CHECK(numStroked <= 2 * 12); // the edges of a box
}

TEST_CASE("R on the Cornell box shows the shapes that --debug-ray writes, as JSON and as SVG", "[window]")
{
    OpenedWindow window { tests::cornell, tests::reference };
    follow(window, { 800, 430 });
    const worker::DebugRay& ray = window.application.ray().followed().value();
    const files_test::TemporaryFolder folder;
    for (const std::string name : { "ray.json", "ray.svg" }) {
        const std::string command
            = fmt::format("{}/framework/raywork-render {} --size {}x{} --debug-ray {},{} -o {} > /dev/null",
                submission::buildDirectory, tests::cornell.string(), ray.size.x, ray.size.y, ray.pixel.x, ray.pixel.y,
                (folder / name).string());
        REQUIRE(std::system(command.c_str()) == 0);
    }
    CHECK(ray.shapes.size() > 10);
    CHECK(app::toJson(ray) == files::readText(folder / "ray.json"));

    std::set<std::size_t> shown, written;
    for (const debug::Stroke& stroke : strokesOf(window))
        shown.insert(stroke.shape);
    const std::string svg = files::readText(folder / "ray.svg"), attribute = "data-shape=\"";
    for (std::size_t at = 0; (at = svg.find(attribute, at)) != svg.npos; at += attribute.size())
        written.insert(std::stoul(svg.substr(at + attribute.size())));
    CHECK(shown == written);
    CHECK(shown.size() == ray.shapes.size()); // of which none lies behind the camera
}
