#include "graded.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>
#include <cstdlib>

// What a submission draws is told to who grades, and costs nothing.

namespace {

using Lines = std::vector<std::string>;

const std::string drawNormal
    = "    drawRay({ reflected.origin, hitInfo.normal, 0.2f }, glm::vec3(1.0f, 1.0f, 0.0f));\n";
const std::string drawMirrored = "    drawRay(reflected, glm::vec3(0.0f, 1.0f, 0.0f));\n";
const std::string drawSphere = "    drawSphere(passthrough.origin, 0.01f, hitInfo.material.kd * alpha);\n";
const std::string drawPassthrough = "    drawRay(passthrough, hitColor);\n";
const std::string normals = "2 rays along the normal, yellow, 0.2 long";
const std::string mirrored = "2 rays in the mirrored direction, green, endless";

std::filesystem::path withReplaced(const std::string& file, const std::string& from, const std::string& to)
{
    return copyOfReference(file, [&](const std::string& text) { return replaced(text, from, to); });
}

// Two features are one file's.
std::string fileOf(const std::string& feature)
{
    return feature == "reflection" || feature == "transparency" ? "recursive" : feature;
}

Lines drawn(const Graded& graded, const std::string& feature)
{
    INFO(graded.printed);
    return graded.json.at("observations").at(feature).at("drawn");
}

Lines expected(const Graded& graded, const std::string& feature)
{
    return graded.json.at("observations").at(feature).at("expected");
}

bool isComplete(const Graded& graded)
{
    return graded.exitCode == 0 && graded.json.at("score") == graded.json.at("max_score");
}

const std::string heading = "drawn (no points)";

}

TEST_CASE("The reference draws what is expected, and that is what the solution is known to draw", "[grading]")
{
    const Graded graded = grade(copyOfReference("", nullptr));
    INFO(graded.printed);
    REQUIRE(graded.json.at("observations").size() == 7);
    for (const auto& observation : graded.json.at("observations"))
        CHECK(observation.at("drawn") == observation.at("expected"));
    CHECK(drawn(graded, "reflection") == Lines { normals, mirrored });
    const Lines transparency = drawn(graded, "transparency");
    REQUIRE(transparency.size() == 2);
    CHECK(transparency[0] == "3 spheres at a surface, kd * alpha, of radius 0.01");
    CHECK_THAT(transparency[1], Catch::StartsWith("3 rays on through the surface, (") && Catch::EndsWith(", endless"));
    const Lines bvh = drawn(graded, "bvh");
    REQUIRE(bvh.size() == 3);
    CHECK_THAT(bvh[0], Catch::EndsWith(" boxes, from yellow to red, ever redder, wireframe"));
    CHECK_THAT(bvh[1], Catch::EndsWith(" spheres on a box, from yellow to red, ever redder, of radius 0.005"));
    CHECK(bvh[2] == "1 triangle that is hit");
    CHECK(drawn(graded, "light") == Lines { "32 rays to a light (32 light samples), red" });
    for (const char* const feature : { "shading", "interpolation", "texture" })
        CHECK(drawn(graded, feature) == Lines { "nothing" }); // of what the other files draw, none is theirs
    CHECK_THAT(graded.printed, !Catch::Contains(heading));
}

TEST_CASE("A file that draws nothing is told to, and has all points", "[grading]")
{
    const auto folder = copyOfReference("recursive", [](std::string text) {
        for (const std::string& line : { drawNormal, drawMirrored, drawSphere, drawPassthrough })
            text = replaced(text, line, "");
        return text;
    });
    const Graded graded = grade(folder);
    INFO(graded.printed);
    CHECK(isComplete(graded));
    CHECK(drawn(graded, "reflection") == Lines { "nothing" });
    CHECK(expected(graded, "reflection") == Lines { normals, mirrored });
    CHECK(drawn(graded, "transparency") == Lines { "nothing" });
    CHECK(drawn(graded, "bvh") == expected(graded, "bvh"));
    CHECK_THAT(graded.printed,
        Catch::Contains(heading) && Catch::Contains("drew      nothing\n")
            && Catch::Contains("solution  " + normals + "\n      solution  " + mirrored));
}

TEST_CASE("Drawings that differ in one thing are told apart", "[grading]")
{
    struct Change {
        std::string feature, from, to, line;
    };
    const Change change = GENERATE(values<Change>({
        { "reflection", "glm::vec3(1.0f, 1.0f, 0.0f)", "glm::vec3(0.0f, 0.0f, 1.0f)",
            "2 rays along the normal, (0, 0, 1), 0.2 long" },
        { "reflection", "hitInfo.normal, 0.2f", "hitInfo.normal, 2.0f", "2 rays along the normal, yellow, 2 long" },
        { "reflection", "{ reflected.origin, hitInfo.normal, 0.2f }", "{ reflected.origin, hitInfo.normal }",
            "2 rays along the normal, yellow, endless" },
        { "reflection", "hitInfo.normal, 0.2f", "-hitInfo.normal, 0.2f",
            "2 rays against the normal, yellow, 0.2 long" },
        { "reflection", "hitInfo.normal, 0.2f", "hitInfo.normal + glm::vec3(0, 1, 0), 0.2f",
            "2 rays from a surface in another direction, yellow, 0.28 long" },
        { "reflection", "{ reflected.origin, hitInfo.normal", "{ glm::vec3(9.0f), hitInfo.normal",
            "2 rays elsewhere, yellow" },
        { "reflection", "drawRay(reflected, glm::vec3(0.0f, 1.0f, 0.0f))", "drawRay(ray, glm::vec3(0.0f, 1.0f, 0.0f))",
            "1 ray up to a surface, green" },
        { "transparency", "hitInfo.material.kd * alpha", "hitInfo.material.kd",
            "3 spheres at a surface, kd, of radius 0.01" },
        { "transparency", "drawSphere(passthrough.origin, 0.01f", "drawSphere(glm::vec3(9.0f), 0.01f",
            "3 spheres elsewhere, (" },
        { "bvh", "1.0f - visited++ / last", "visited++ / last",
            "boxes, from red to yellow, but not ever redder, wireframe" },
        { "bvh", "DrawMode::Wireframe", "DrawMode::Filled", "boxes, from yellow to red, ever redder, filled" },
        { "bvh", "drawTriangle(closest->v0, closest->v1, closest->v2)",
            "drawTriangle(bvh.primitives()[0].v0, bvh.primitives()[0].v1, bvh.primitives()[0].v2)",
            "1 triangle that is not hit" },
        { "light", "distance }, glm::vec3(1.0f, 0.0f, 0.0f)", "distance }, glm::vec3(1.0f)",
            "32 rays to a light (32 light samples), white" },
        { "light", "lightDirection, distance }", "lightDirection, 0.5f * distance }",
            "32 rays towards a light, red, " },
        { "light", "drawRay({ point, lightDirection, distance }, glm::vec3(1.0f, 0.0f, 0.0f));",
            "if (lightColor.b > 0.3f) drawRay({ point, lightDirection, distance }, glm::vec3(1.0f, 0.0f, 0.0f));",
            "16 rays to a light (32 light samples), red" },
        { "texture", "    const int i\n", "    drawRay({}, glm::vec3(1.0f));\n    const int i\n",
            "1 ray elsewhere, white" },
    }));
    INFO(change.from << " -> " << change.to);
    const auto folder = copyOfReference(fileOf(change.feature),
        [&](const std::string& text) { return "#include \"draw.h\"\n" + replaced(text, change.from, change.to); });
    const Graded graded = grade(folder, "--only " + change.feature);
    CHECK(isComplete(graded));
    CHECK_THAT(drawn(graded, change.feature),
        Catch::Matchers::Predicate<Lines>(
            [&](const Lines& lines) {
                return std::ranges::any_of(
                    lines, [&](const std::string& line) { return line.find(change.line) != std::string::npos; });
            },
            "has a line with: " + change.line));
    CHECK(drawn(graded, change.feature) != expected(graded, change.feature));
}

TEST_CASE("Where the submission has a renderRay of its own, its drawing is told all the same", "[grading]")
{
    const auto folder = copyOfReference("recursive", [](const std::string& text) {
        return "#include \"bvh_interface.h\"\n#include \"light.h\"\n" + text + R"(
glm::vec3 renderRay(RenderState& state, Ray ray, int rayDepth)
{
    HitInfo hit;
    if (!state.bvh.intersect(state, ray, hit)) {
        drawRay(ray, glm::vec3(1.0f, 0.0f, 0.0f));
        return glm::vec3(0.0f);
    }
    drawRay(ray);
    glm::vec3 color = computeLightContribution(state, ray, hit);
    if (rayDepth < 6 && state.features.enableReflections && hit.material.ks != glm::vec3(0.0f))
        renderRaySpecularComponent(state, ray, hit, color, rayDepth);
    if (rayDepth < 6 && state.features.enableTransparency && hit.material.transparency != 1.0f)
        renderRayTransparentComponent(state, ray, hit, color, rayDepth);
    return color;
}
)";
    });
    const Graded graded = grade(folder, "--only reflection");
    CHECK(isComplete(graded));
    CHECK(drawn(graded, "reflection") == Lines { normals, mirrored });
}

TEST_CASE("A worker that fails while it is observed says so in a line, and loses nothing", "[grading]")
{
    // Only then are drawings wanted.
    const auto [failure, line] = GENERATE(table<std::string, std::string>({
        { "*static_cast<volatile int*>(nullptr) = 0;", "unknown: Segmentation fault" },
        { "for (volatile bool forever = true; forever;) { }", "unknown: no answer in time" },
        { "std::_Exit(0);", "unknown: ended by itself" },
        { "throw std::runtime_error(\"a \\x1b[31m\\nline\" + std::string(5000, 'x'));",
            "unknown: threw an exception: a ?[31m line" },
    }));
    const auto folder = copyOfReference("recursive", [&, to = failure](const std::string& text) {
        return "#include <cstdlib>\n#include <stdexcept>\n"
            + replaced(text, drawNormal, "if (state.features.enableDebugDraw) { " + to + " }\n");
    });
    const Graded graded = grade(folder);
    INFO(graded.printed);
    CHECK(isComplete(graded));
    const Lines lines = drawn(graded, "reflection");
    REQUIRE(lines.size() == 1);
    CHECK_THAT(lines[0], Catch::StartsWith(line) && !Catch::Contains("\n") && !Catch::Contains("\x1b"));
    CHECK(lines[0].size() <= 200);
    CHECK(drawn(graded, "transparency") == expected(graded, "transparency"));
}

TEST_CASE("Drawing without end is looked at in part", "[grading]")
{
    const auto folder = withReplaced("recursive", drawNormal,
        "    for (int i = 0; state.features.enableDebugDraw && i < 200'000; ++i)\n    " + drawNormal);
    const Graded graded = grade(folder, "--only reflection");
    CHECK(isComplete(graded));
    CHECK(drawn(graded, "reflection").back() == "and more, which is not looked at");
}

TEST_CASE("A file that ends in a crash or never is not observed, and the others are", "[grading]")
{
    const auto failure = GENERATE(values<std::string>(
        { "for (volatile bool forever = true; forever;) { }", "*static_cast<volatile int*>(nullptr) = 0;" }));
    const auto folder = withReplaced(
        "texture", "    return std::min(std::max(0.0f, x)", "    " + failure + "    return std::min(std::max(0.0f, x)");
    const Graded graded = grade(folder);
    INFO(graded.printed);
    CHECK(graded.lost("texture") == 10.0);
    CHECK(graded.json.at("observations").size() == 6);
    CHECK_FALSE(graded.json.at("observations").contains("texture"));
    for (const auto& observation : graded.json.at("observations"))
        CHECK(observation.at("drawn") == observation.at("expected"));
}

TEST_CASE("Of stubs no drawing is asked", "[grading]")
{
    const Graded graded = grade(std::filesystem::path(submission::sourceDirectory) / "student");
    CHECK(graded.json.at("observations").empty());
}

TEST_CASE("The drawing of a feature with a hidden check is hidden", "[grading]")
{
    const auto folder = withReplaced("recursive", drawNormal, "");
    const std::string html = (workFolder() / "page.html").string();
    const Graded graded = grade(folder, "--only reflection --hide 'reflection.picture.*' --html '" + html + "'");
    CHECK(isComplete(graded));
    CHECK(graded.json.at("observations").empty());
    CHECK_THAT(graded.printed, !Catch::Contains(heading));
    CHECK(std::system(("grep -q solutionDraws.: '" + html + "'").c_str()) != 0);
}

TEST_CASE("Recorded answers know what the solution draws", "[grading]")
{
    const std::string golden = (workFolder() / "golden").string();
    const auto folder = withReplaced("recursive", drawNormal, "");
    const std::string program = std::string(submission::buildDirectory) + "/grading/raywork-grade";
    REQUIRE(std::system((program + " --only reflection --record '" + golden + "'").c_str()) == 0);
    const Graded recorded = grade(folder, "--only reflection --reference-worker /nowhere --golden '" + golden + "'");
    CHECK(isComplete(recorded));
    CHECK(drawn(recorded, "reflection") == Lines { mirrored });
    CHECK(expected(recorded, "reflection") == Lines { normals, mirrored });
}
