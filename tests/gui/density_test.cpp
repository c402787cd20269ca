#include "changed_reference.h"
#include "gui/scale.h"
#include "opened_window.h"
#include <catch2/catch.hpp>
#include <glm/gtx/component_wise.hpp>

// A screen twice as dense, on which what is drawn is to be as large as on another one.

using tests::OpenedWindow;

namespace {

struct Measures {
    glm::ivec2 window, picture;
    float fontSize, letterWidth, frameHeight;
    double disc, stroke; // how much is drawn
};

// Of the part right of the panel and above the strip that tells of times. A pixel that is half covered counts half.
double difference(const gui::Picture& a, const gui::Picture& b)
{
    double sum = 0.0;
    const glm::ivec2 first = glm::ivec2(360, 36) * (a.size.x / 1280);
    for (std::size_t i = static_cast<std::size_t>(first.y * a.size.x); i < a.pixels.size(); ++i)
        if (static_cast<int>(i) % a.size.x > first.x)
            sum += static_cast<double>(glm::compAdd(glm::abs(a.pixels[i] - b.pixels[i])));
    return sum;
}

Measures measure(int density)
{
    OpenedWindow window { tests::source / "scenes" / "single_triangle.toml", tests::reference, density };
    const CameraConfig& camera = window.application.document().settings.config.camera;
    window.application.document().settings.lights = { PointLight { camera.lookAt, glm::vec3(1.0f) } };
    window.drawUntilTraced();
    window.drawUntil([&] { return window.application.tree().drawing().numLevels > 0; });
    window.showOnly("lights");
    const gui::Picture plain = window.screenshot();
    window.activate("light handles");
    const gui::Picture withDisc = window.screenshot();
    window.activate("light handles");
    window.showOnly("tree");
    window.activate("level");
    window.drawUntil([&] { return !window.application.tree().drawing().shapes.empty(); });
    const gui::Picture withBox = window.screenshot();
    const ImFont* const font = ImGui::GetIO().Fonts->Fonts[0];
    return { plain.size, window.application.picture().size, font->FontSize, font->GetCharAdvance('m'),
        ImGui::GetStyle().FramePadding.y, difference(plain, withDisc), difference(plain, withBox) };
}

}

TEST_CASE("On a screen twice as dense all that is drawn has twice as many pixels each way", "[window]")
{
    const Measures one = measure(1), two = measure(2);
    CHECK(two.window == 2 * one.window);
    CHECK(two.picture == 2 * one.picture);
    CHECK(two.fontSize == 2.0f * one.fontSize);
    CHECK(two.letterWidth == 2.0f * one.letterWidth);
    CHECK(two.frameHeight == 2.0f * one.frameHeight);
    // Discs and lines are polygons whose corners ImGui places as it likes within a pixel or so.
    CHECK(two.disc / one.disc == Approx(4.0).epsilon(0.1));
    CHECK(two.stroke / one.stroke == Approx(4.0).epsilon(0.1));
}
