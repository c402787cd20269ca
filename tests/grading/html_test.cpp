#include "browser/browser.h"
#include "files/temporary_folder.h"
#include "graded.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <fmt/format.h>

// The page of a grade, read by a browser.

namespace {

using browser::Browser;
using browser::Point;

std::filesystem::path withBlendedTheWrongWayRound()
{
    return copyOfReference("recursive", [](const std::string& text) {
        return replaced(text, "glm::mix(renderRay(state, passthrough, rayDepth + 1), hitColor, alpha)",
            "glm::mix(hitColor, renderRay(state, passthrough, rayDepth + 1), alpha)");
    });
}

// The page of a submission with pictures that differ, and its grade as JSON. Graded once.
struct Page {
    Page()
        : path(folder / "page.html")
        , graded(grade(withBlendedTheWrongWayRound(),
              "--hide '*.ray.*' --junit '" + (folder / "junit.xml").string() + "' --html '" + path.string() + "'"))
    {
    }

    files_test::TemporaryFolder folder;
    std::filesystem::path path;
    Graded graded;
};

// Runs as a function's body with `picture` the part of the page that compares the pictures of the check.
std::string inViewer(const std::string& body)
{
    return "(() => { const picture = document.querySelector('[open] .viewer'); " + body + " })()";
}

// A place on an element of the viewer, scrolled into view: shares of its width and height.
Point placeOn(Browser& browser, const std::string& selector, double x, double y)
{
    const auto place
        = browser.evaluate(inViewer(fmt::format("const element = picture.querySelector('{}'); "
                                                "element.scrollIntoView({{ block: 'center', behavior: 'instant' }});"
                                                "const box = element.getBoundingClientRect();"
                                                "return [box.left + {} * box.width, box.top + {} * box.height];",
            selector, x, y)));
    return { place[0], place[1] };
}

// How many of the rows that are wanted there are to be seen.
int countVisible(Browser& browser, const std::string& selector)
{
    return browser.evaluate(
        "[...document.querySelectorAll('" + selector + "')].filter((row) => row.checkVisibility()).length");
}

// The three numbers of a line of the table.
std::vector<double> shownValues(Browser& browser, const std::string& line)
{
    return browser.evaluate(inViewer("return [...picture.querySelectorAll('tbody tr')]"
                                     ".find((row) => row.cells[0].textContent === '"
        + line + "').innerText.split('\\t').slice(1).map(Number);"));
}

}

// One test: grading once and starting one browser are most of its time.
TEST_CASE("The page of a grade tells a student what was lost, and shows the pictures", "[grading]")
{
    static const Page page;
    static Browser browser;
    const auto isWrong = [](const auto& check) { return check.value("status", "hidden") == "wrong"; };
    const auto numWrong = std::ranges::count_if(page.graded.json.at("checks"), isWrong);
    INFO(page.graded.printed);
    browser.setView(1200, 900);

    SECTION("The page shows a row a check, loads nothing but itself, and has no error")
    {
        browser.open(page.path);
        CHECK(countVisible(browser, ".check") == static_cast<int>(page.graded.json.at("checks").size()));
        CHECK(countVisible(browser, ".check.wrong") == numWrong);
        CHECK(browser.complaints() == std::vector<std::string> {});
        CHECK_FALSE(browser.requests().empty());
        for (const std::string& address : browser.requests())
            CHECK((address == "file://" + page.path.string() || address.starts_with("data:")));
    }

    SECTION("The filter leaves the rows that lost points")
    {
        browser.open(page.path);
        browser.evaluate("document.querySelector('[value=lost]').click()");
        CHECK(countVisible(browser, ".check.wrong") == numWrong);
        CHECK(countVisible(browser, ".check.passed") == 0);
        CHECK(countVisible(browser, ".check.hidden") == 0); // whether it lost any is hidden too
    }

    SECTION("A hidden check shows its name and nothing else")
    {
        browser.open(page.path);
        REQUIRE(countVisible(browser, ".check.hidden") > 0);
        CHECK(browser
                  .evaluate("[...document.querySelectorAll('.check.hidden')].every((row) => "
                            "/^\\?\\s*\\w+\\.ray\\.\\w+\\s*hidden\\s*$/.test(row.innerText))")
                  .get<bool>());
        CHECK(browser
                  .evaluate("grade.features.flatMap((feature) => feature.checks)"
                            ".filter((check) => check.status === 'hidden')"
                            ".every((check) => Object.keys(check).join() === 'name,status')")
                  .get<bool>());
    }

    SECTION("What was drawn stands in the section of its feature, open where the solution draws something else")
    {
        browser.open(page.path);
        const auto& observations = page.graded.json.at("observations");
        REQUIRE_FALSE(observations.empty());
        CHECK(countVisible(browser, ".drawn") == static_cast<int>(observations.size()));
        for (const auto& [feature, observation] : observations.items()) {
            const std::string drawn = "document.querySelector('#" + feature + " .drawn')";
            CHECK(browser.evaluate(drawn + ".open") == (observation.at("drawn") != observation.at("expected")));
            CHECK(browser.evaluate("[..." + drawn + ".querySelector('ul').children].map((line) => line.textContent)")
                == observation.at("drawn"));
        }
        CHECK(browser.evaluate("makeDrawn({ drawn: ['a'], solutionDraws: ['b'] }).open") == true);
    }

    SECTION("All pictures are drawn")
    {
        browser.open(page.path);
        // Of each canvas: how many colours, and whether all of it was drawn.
        const auto canvases = browser.evaluate("[...document.querySelectorAll('canvas')].map((canvas) => {"
                                               "const { data } = canvas.getContext('2d').getImageData(0, 0, "
                                               "canvas.width, canvas.height);"
                                               "return { colors: new Set(new Uint32Array(data.buffer)).size,"
                                               "opaque: data.every((byte, i) => i % 4 != 3 || byte == 255),"
                                               "plain: canvas.closest('.crops, .passed .difference') != null } })");
        CHECK(canvases.size() >= 6);
        for (const auto& canvas : canvases) {
            CHECK(canvas.at("opaque") == true);
            CHECK((canvas.at("plain") == true || canvas.at("colors") > 1)); // a place, or no difference
        }
    }

    SECTION("Dragging the line shows more of the one picture and less of the other")
    {
        browser.open(page.path);
        const Point middle = placeOn(browser, ".compare", 0.5, 0.5);
        const Point right = placeOn(browser, ".compare", 0.9, 0.5);
        const std::string before = browser.screenshot();
        browser.drag(middle, right);
        const double split = browser.evaluate(inViewer("return +picture.querySelector('.split').value"));
        CHECK(split == Approx(90.0).margin(1.0)); // the slider has steps of a half, the mouse of a pixel
        const double cut = browser.evaluate(
            inViewer("return parseFloat(getComputedStyle(picture.querySelector('.came')).clipPath.split(' ').pop())"));
        CHECK(cut == Approx(split));
        CHECK(browser.screenshot() != before);
    }

    SECTION("The values under the mouse are those of the pixel, and the arrow keys go to the next")
    {
        browser.open(page.path);
        // The middle of pixel (48, 40) of 64 x 64.
        browser.hover(placeOn(browser, ".difference", 48.5 / 64.0, 1.0 - 40.5 / 64.0));
        const auto expectShown = [&](int x, int y) {
            CHECK(browser.evaluate(inViewer("return picture.querySelector('caption').textContent"))
                == fmt::format("Pixel ({}, {}) from the bottom left", x, y));
            const auto floats = [&](const char* picture) -> std::vector<double> {
                return browser.evaluate(fmt::format(
                    "(() => {{ const all = grade.features.flatMap((feature) => feature.checks).find((check) => "
                    "check.pictures && check.status === 'wrong').pictures;"
                    "return [...decode(all.{}).slice(3 * ({} * 64 + {})).slice(0, 3)] }})()",
                    picture, y, x));
            };
            const std::vector<double> expected = floats("expected"), came = floats("came");
            for (std::size_t c = 0; c < 3; ++c) {
                CHECK(shownValues(browser, "expected").at(c)
                    == Approx(expected.at(c)).epsilon(1e-5)); // six digits; below, four
                CHECK(shownValues(browser, "yours").at(c) == Approx(came.at(c)).epsilon(1e-5));
                CHECK(shownValues(browser, "difference").at(c) == Approx(came.at(c) - expected.at(c)).epsilon(1e-3));
            }
        };
        expectShown(48, 40);
        browser.evaluate(inViewer("picture.querySelector('.difference').focus()"));
        browser.press("ArrowUp");
        expectShown(48, 41);
    }

    SECTION("On a phone nothing is wider than the screen")
    {
        browser.setView(360, 740);
        browser.open(page.path);
        CHECK(browser.evaluate("document.documentElement.scrollWidth") == 360);
    }

    SECTION("The JUnit file is XML to a parser that forgives nothing")
    {
        browser.open(page.folder / "junit.xml");
        CHECK(browser.evaluate("document.querySelectorAll('parsererror').length") == 0);
        CHECK(browser.evaluate("document.querySelectorAll('testcase').length") == page.graded.json.at("checks").size());
    }
}
