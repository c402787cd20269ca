#include "graded.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>
#include <vector>

// Copies of the reference with one mistake each lose points of that feature and of no other.

namespace {

struct Mistake {
    std::string name, feature, file, from, to, status;
};

const std::string infiniteLoop = "    for (volatile bool forever = true; forever;) { }\n";

const std::vector<Mistake> mistakes {
    { "transparency blended the wrong way round", "transparency", "recursive",
        "glm::mix(renderRay(state, passthrough, rayDepth + 1), hitColor, alpha)",
        "glm::mix(hitColor, renderRay(state, passthrough, rayDepth + 1), alpha)", "wrong" },
    { "reflected light replaces the colour", "reflection", "recursive", "hitColor += hitInfo.material.ks",
        "hitColor = hitInfo.material.ks", "wrong" },
    { "light colour squared", "light", "light", "return computeShading(state, cameraDirection",
        "return visible * computeShading(state, cameraDirection", "wrong" },
    { "nearest texel off by a half", "texture", "texture", "std::floor(texCoord.x * static_cast<float>(image.width))",
        "std::floor(texCoord.x * static_cast<float>(image.width) + 0.5f)", "wrong" },
    { "last hit kept instead of the nearest", "bvh", "bvh",
        "if (intersectRayWithTriangle(p.v0.position, p.v1.position, p.v2.position, ray, unused))",
        "ray.t = FLT_MAX; if (intersectRayWithTriangle(p.v0.position, p.v1.position, p.v2.position, ray, unused))",
        "wrong" },
    { "unsorted components taken as sorted", "shading", "shading",
        "component.t <= ti && (!below || component.t > below->t)", "component.t <= ti", "wrong" },
    { "interpolated normal not unit", "interpolation", "interpolate", "length > 0.0f ? sum / length : n0", "sum",
        "wrong" },
    { "jitter over the whole pixel", "multisampling", "render",
        "(glm::vec2(x, y) + state.sampler.next_2d()) / static_cast<float>(n)", "state.sampler.next_2d()", "wrong" },
    { "null pointer dereferenced", "texture", "texture", "    return image.get_pixel(j * image.width + i);",
        "    return *static_cast<volatile float*>(nullptr) * image.get_pixel(j * image.width + i);", "crashed" },
    { "endless loop", "light", "light", "    const Ray toLight = shadowRay(lightPosition, ray, hitInfo);\n",
        "    const Ray toLight = shadowRay(lightPosition, ray, hitInfo);\n" + infiniteLoop, "timed out" },
};

}

TEST_CASE("A mistake costs points of its own feature alone", "[grading]")
{
    const Mistake mistake = GENERATE(from_range(mistakes));
    INFO(mistake.name);
    const auto folder = copyOfReference(
        mistake.file, [&](const std::string& text) { return replaced(text, mistake.from, mistake.to); });
    const Graded graded = grade(folder);
    INFO(graded.printed);
    CHECK(graded.exitCode == 0);
    CHECK(graded.lost(mistake.feature) > 0.0);
    CHECK(graded.lostElsewhere(mistake.feature) == 0.0);
    CHECK(graded.count(mistake.feature, mistake.status) > 0);
}

TEST_CASE("A file that does not compile costs its own feature and shows the compiler's message", "[grading]")
{
    const auto folder = copyOfReference("shading", [](const std::string& text) { return text + "int broken = ;\n"; });
    const Graded graded = grade(folder);
    INFO(graded.printed);
    CHECK(graded.lost("shading") == 10.0);
    CHECK(graded.lostElsewhere("shading") == 0.0);
    for (const auto& check : graded.json.at("checks")) {
        if (check.at("feature") != "shading")
            continue;
        CHECK(check.at("status") == "refused");
        CHECK_THAT(check.at("message").get<std::string>(), Catch::Contains("shading.cpp:") && Catch::Contains("error"));
    }
}

TEST_CASE("A file that includes what is not part of the interface is refused", "[grading]")
{
    const std::string solution = std::string(submission::sourceDirectory) + "/reference/texture.cpp";
    const auto include = GENERATE_COPY(values<std::string>({ solution, "accel/traversal.h" }));
    const auto folder
        = copyOfReference("texture", [&](const std::string&) { return "#include \"" + include + "\"\n"; });
    const bool isLockedIn = GENERATE(true, false); // then it is not even there
    const Graded graded = grade(folder, isLockedIn ? "--only texture" : "--only texture --sandbox off");
    INFO(graded.printed);
    CHECK(graded.json.at("score") == 0);
    CHECK(graded.count("texture", "refused") > 0);
    CHECK_THAT(graded.json.at("checks").at(0).at("message").get<std::string>(),
        Catch::Contains(isLockedIn ? "fatal error: " + include : "which is not part of the interface"));
    CHECK((graded.printed.find("not sandboxed: turned off") == std::string::npos) == isLockedIn);
    CHECK(graded.json.at("sandbox") == (isLockedIn ? "bubblewrap" : "none: turned off"));
}

TEST_CASE("What a submission prints costs nothing", "[grading]")
{
    const auto folder = copyOfReference("texture", [](const std::string& text) {
        return "#include <iostream>\n"
            + replaced(text, "    return image.get_pixel(j * image.width + i);",
                "    for (int k = 0; k < 10000; ++k) std::cout << \"sampling\\n\";\n"
                "    return image.get_pixel(j * image.width + i);");
    });
    const Graded graded = grade(folder, "--only texture");
    INFO(graded.printed);
    CHECK(graded.count("texture", "crashed") == 0);
    CHECK(graded.count("texture", "wrong") == 0);
}

TEST_CASE("A function with a changed signature is named", "[grading]")
{
    const auto folder = copyOfReference("texture", [](const std::string& text) {
        return replaced(text, "sampleTextureNearest(const Image& image, const glm::vec2& texCoord)",
            "sampleTextureNearest(const Image& image, glm::vec2& texCoord)");
    });
    const Graded graded = grade(folder, "--only texture");
    INFO(graded.printed);
    CHECK(graded.count("texture", "not attempted") > 0);
    CHECK(graded.count("texture", "passed") > 0); // bilinear lookups are right
    for (const auto& check : graded.json.at("checks"))
        if (check.at("name") == "texture.nearest.inside")
            CHECK_THAT(check.at("message").get<std::string>(),
                Catch::Contains("texture.cpp:") && Catch::Contains("no previous declaration"));
}

TEST_CASE("A file that is missing is not attempted", "[grading]")
{
    const auto folder = copyOfReference("bvh", [](const std::string& text) { return text; });
    std::filesystem::remove(folder / "bvh.cpp");
    const Graded graded = grade(folder);
    INFO(graded.printed);
    CHECK(graded.lost("bvh") == 20.0);
    CHECK(graded.lostElsewhere("bvh") == 0.0);
    CHECK(graded.count("bvh", "not attempted") > 0);
}
