// The page as a browser shows it.
#include "browser/browser.h"
#include "report/made.h"
#include "report/section.h"
#include "report/text.h"
#include <catch2/catch.hpp>

namespace {

using nlohmann::json;

json titlesOfSections()
{
    json titles = json::array();
    for (const report::Section& section : report::sections)
        titles.push_back(section.title);
    return titles;
}

// Where the middle of the slider's handle is.
double handleOf(browser::Browser& browser, int slider)
{
    return browser
        .evaluate("(() => { const s = document.querySelectorAll('.split')[" + std::to_string(slider)
            + "]; s.scrollIntoView({ block: 'center', behavior: 'instant' });"
              "return parseFloat(getComputedStyle(s.parentElement).getPropertyValue('--split')); })()")
        .get<double>();
}

browser::Point pointOf(browser::Browser& browser, int slider, double fraction)
{
    const json box = browser.evaluate("(() => { const b = document.querySelectorAll('.stage')[" + std::to_string(slider)
        + "].getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()");
    return { box[0].get<double>() + fraction * box[2].get<double>(), box[1].get<double>() + box[3].get<double>() / 2 };
}

}

TEST_CASE("A page complains of nothing, misses no picture and loads nothing else", "[report]")
{
    const auto submission = GENERATE(std::string("reference"), std::string("student"));
    browser::Browser browser;
    browser.setView(1280, 900);
    browser.open(report_test::madeReport(submission) / "index.html");
    CHECK(
        browser.evaluate("[...document.images].filter(i => !i.closest('dialog') && !(i.complete && i.naturalWidth > 0))"
                         ".map(i => i.alt)")
        == json::array());
    for (const std::string& address : browser.requests())
        CHECK((address.starts_with("file:") || address.starts_with("data:")));
    CHECK(browser.complaints().empty());
}

TEST_CASE("A page has the eight sections in order, each with its four parts", "[report]")
{
    const auto submission = GENERATE(std::string("reference"), std::string("student")); // drawn or not
    browser::Browser browser;
    browser.open(report_test::madeReport(submission) / "index.html");
    const json titles = browser.evaluate("[...document.querySelectorAll('section > h2')].map(h => h.textContent)");
    REQUIRE(titles.size() >= report::sections.size());
    CHECK(json(titles.begin(), titles.begin() + report::sections.size()) == titlesOfSections());
    for (const report::Section& section : report::sections) {
        INFO(section.name);
        const json parts = browser.evaluate("[...document.querySelectorAll('#" + section.name
            + " > h3')]"
              ".map(h => h.textContent)");
        CHECK(parts == json { "Description", "Visual debugging", "Rendered images", "Location" });
    }
}

TEST_CASE("Every slider follows the mouse", "[report]")
{
    browser::Browser browser;
    browser.setView(1280, 900);
    browser.open(report_test::madeReport("reference") / "index.html");
    const int number = browser.evaluate("document.querySelectorAll('.split').length").get<int>();
    REQUIRE(number > 0);
    for (int slider = 0; slider < number; ++slider) {
        INFO(slider);
        CHECK(handleOf(browser, slider) == 50.0);
        browser.drag(pointOf(browser, slider, 0.5), pointOf(browser, slider, 0.25));
        CHECK(handleOf(browser, slider) == Approx(25.0).margin(1.0)); // a pixel or two, of some hundred
    }
}

TEST_CASE("A click enlarges a picture, and another one puts it back", "[report]")
{
    browser::Browser browser;
    browser.setView(1280, 900);
    browser.open(report_test::madeReport("reference") / "index.html");
    browser.evaluate("document.querySelector('.zoom').click()");
    CHECK(browser
              .evaluate("document.querySelector('dialog').open && document.querySelector('dialog img').src"
                        " === document.querySelector('.zoom img').src")
              .get<bool>());
    browser.evaluate("document.querySelector('dialog').click()");
    CHECK_FALSE(browser.evaluate("document.querySelector('dialog').open").get<bool>());
}

TEST_CASE("A page fits a phone", "[report]")
{
    browser::Browser browser;
    browser.setView(360, 740);
    browser.open(report_test::madeReport("reference") / "index.html");
    CHECK(browser.evaluate("document.documentElement.scrollWidth").get<int>() <= 360);
}

TEST_CASE("A page is dark where the reader's system is", "[report]")
{
    browser::Browser browser;
    const auto brightness = [&](const char* property) {
        const json channels = browser.evaluate(
            std::string("getComputedStyle(document.body).") + property + ".match(/\\d+/g).slice(0, 3).map(Number)");
        return (channels[0].get<int>() + channels[1].get<int>() + channels[2].get<int>()) / 3;
    };
    for (const bool dark : { false, true }) {
        browser.setView(1280, 900, dark);
        browser.open(report_test::madeReport("student") / "index.html");
        INFO(dark);
        CHECK((brightness("backgroundColor") < brightness("color")) == dark);
        CHECK(std::abs(brightness("backgroundColor") - brightness("color")) > 150); // of 255: it can be read
    }
}

TEST_CASE("Plots show values when pointed at", "[report]")
{
    browser::Browser browser;
    browser.setView(1280, 900);
    browser.open(report_test::madeReport("reference") / "index.html");
    const json silent = browser.evaluate("[...document.querySelectorAll('.plot svg')].filter(p => "
                                         "!p.querySelector('.value')).map(p => p.closest('figure').id)");
    CHECK(silent == json { "shading.comparison" }); // whose legend has none

    const json point = browser.evaluate(
        "(() => { const p = document.querySelectorAll('[id=\"shading.lobes\"] .value')[8];"
        "p.scrollIntoView({ block: 'center', behavior: 'instant' }); const b = p.getBoundingClientRect();"
        "return [b.x + b.width / 2, b.y + b.height / 2, p.dataset.value]; })()");
    CHECK(browser.evaluate("document.querySelector('.readout').hidden").get<bool>());
    browser.hover({ point[0].get<double>(), point[1].get<double>() });
    CHECK_FALSE(browser.evaluate("document.querySelector('.readout').hidden").get<bool>());
    CHECK(browser.evaluate("document.querySelector('.readout').textContent") == point[2]);
    CHECK(point[2] == "-50°: Phong 0.858, Blinn-Phong 0.963"); // cos(10°)^10 and cos(5°)^10
    browser.hover({ 2, 2 });
    CHECK(browser.evaluate("document.querySelector('.readout').hidden").get<bool>());
    CHECK(browser.complaints().empty());
}

TEST_CASE("A page opens with what is missing, and with grade and stress where they are known", "[report]")
{
    browser::Browser browser;
    const auto textOf = [&](const std::string& selector) {
        return browser.evaluate("[...document.querySelectorAll('" + selector + "')].map(e => e.textContent)");
    };
    browser.open(report_test::madeReport("student") / "index.html");
    std::size_t numQuestions = 0;
    for (const report::Section& section : report::sections)
        numQuestions
            += report::readText(section, report_test::madeReport("student") / "../student/report").questions.size();
    CHECK(textOf(".open q").size() == numQuestions);
    CHECK(textOf(".results table").empty());

    browser.open(report_test::madeReport("reference") / "index.html");
    CHECK(textOf(".open").empty());
    CHECK(textOf(".grade th") == json { "Grade", "95 / 100" });
    CHECK(textOf(".grade tbody tr").size() == report::sections.size());
    CHECK(textOf(".stress tbody tr:first-child td") == json { "all", "3000", "0", "38" });
    CHECK(browser
              .evaluate("!!(document.querySelector('.grade').compareDocumentPosition(document.querySelector("
                        "'section')) & Node.DOCUMENT_POSITION_FOLLOWING)")
              .get<bool>());
}
