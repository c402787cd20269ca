#include "changed_reference.h"
#include "opened_window.h"
#include <catch2/catch.hpp>

// What a submission's code prints, in the window.

using tests::OpenedWindow;

namespace {

// A light whose function does this first.
std::string lightThat(const std::string& statements)
{
    return "#include \"light.h\"\n#include <atomic>\n#include <cstdio>\n#include <iostream>\n"
           "glm::vec3 computeContributionPointLight(RenderState&, const PointLight&, const Ray&, const HitInfo&)\n{\n"
        + statements + "\nreturn glm::vec3(0.5f);\n}\n";
}

bool isPrinted(const OpenedWindow& window, const std::string& line)
{
    return std::ranges::count(window.application.printed().lines(), line) > 0;
}

}

TEST_CASE("What is printed on either way is shown, ended or not, and cleared by the button", "[window]")
{
    const tests::ChangedReference folder { "light.cpp", lightThat(R"(
        static std::atomic<bool> isFirst = true;
        if (isFirst.exchange(false)) {
            std::cout << "one\ntwo" << std::endl;
            std::cerr << "three\n";
            std::printf("not ended");
        })") };
    OpenedWindow window { tests::cornell, folder.path() };
    window.drawUntil([&] { return isPrinted(window, "not ended"); });
    CHECK(isPrinted(window, "one"));
    CHECK(isPrinted(window, "two"));
    CHECK(isPrinted(window, "three"));
    window.drawUntilTraced();
    window.showOnly("output");
    window.activate("clear");
    CHECK(window.application.printed().lines().empty());
}

TEST_CASE("The section of what is printed opens when the first comes, and stays closed when it is closed", "[window]")
{
    const tests::ChangedReference folder { "light.cpp", lightThat("std::puts(\"again\");") };
    OpenedWindow window { tests::cornell, folder.path() };
    window.showOnly("none");
    window.drawUntil([&] { return isPrinted(window, "again"); });
    window.drawFrames(2);
    CHECK(window.isOpen("output"));
    window.activate("output");
    CHECK_FALSE(window.isOpen("output"));
    window.drawFrames(5);
    CHECK_FALSE(window.isOpen("output"));
}

TEST_CASE("What code printed before it looped or crashed is shown, also while nobody answers", "[window]")
{
    const std::string end = GENERATE("for (volatile bool forever = true; forever;) { }",
        "*static_cast<volatile int*>(nullptr) = 0;", "std::_Exit(0);");
    const tests::ChangedReference folder { "light.cpp", lightThat("std::cout << \"last words\\n\";" + end) };
    OpenedWindow window { tests::cornell, folder.path() };
    window.drawUntil([&] { return isPrinted(window, "last words"); });
    folder.repair();
    window.drawUntil([&] { return window.application.isPictureDone() && window.application.message().empty(); });
    CHECK(isPrinted(window, "last words"));
}

TEST_CASE("What a worker printed is not lost when another one takes its place before it was taken", "[gui]")
{
    const tests::ChangedReference folder { "light.cpp",
        lightThat("std::cout << \"last words\\n\"; *static_cast<volatile int*>(nullptr) = 0;") };
    const gui::Document document { tests::cornell };
    Config config = document.settings.config;
    config.size = { 32, 32 };
    gui::Tracer tracer { folder.path() };
    const auto waitUntil = [](const auto& isSo) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        while (!isSo()) {
            std::this_thread::yield();
            if (std::chrono::steady_clock::now() > end)
                FAIL("waited in vain");
        }
    };
    tracer.show(document.path(), { makeTrackball(config), config.features, document.settings.lights, config.size });
    waitUntil([&] { return tracer.message().find("Segmentation fault") != std::string::npos; });
    folder.repair();
    waitUntil([&] { return tracer.takePicture().has_value(); });
    CHECK_THAT(tracer.takePrinted(), Catch::Contains("last words\n"));
    CHECK(tracer.takePrinted().empty());
}

TEST_CASE("Of a flood of lines the newest are kept, and the picture is completed", "[window]")
{
    const tests::ChangedReference folder { "light.cpp", lightThat(R"(
        static int number = 0;
        flockfile(stdout); // counted in the order of printing: no thread is late with a low number
        std::printf("line %d\n", ++number);
        funlockfile(stdout);)") };
    OpenedWindow window { tests::cornell, folder.path() };
    window.drawUntilTraced();
    window.drawFrames(2);
    const auto& lines = window.application.printed().lines();
    REQUIRE(lines.size() == gui::OutputLines::most);
    const auto numberOf = [](const std::string& line) { return std::stoi(line.substr(5)); };
    CHECK(numberOf(lines.back()) > 100'000); // of about a million
    CHECK(numberOf(lines.back()) > numberOf(lines.front()));
}
