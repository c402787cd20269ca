#include "files/picture.h"
#include "files/text.h"
#include "graded.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <glm/common.hpp>
#include <glm/gtx/component_wise.hpp>
#include <sys/wait.h>

// Files as students of the course write them: they define provided functions such as renderRay and renderImage again,
// lean on headers that others bring in, have helpers with global names, and were never compiled with our warnings.

namespace fs = std::filesystem;

namespace {

const fs::path here = fs::path(submission::sourceDirectory) / "tests" / "grading";

// Files of the first edition take the place of those that changed since.
fs::path firstEdition()
{
    const fs::path folder = workFolder() / "course_2023";
    fs::create_directories(folder);
    for (const fs::path& files : { here / "course", here / "course_2023" })
        fs::copy(files, folder, fs::copy_options::overwrite_existing | fs::copy_options::recursive);
    // There the uniform samples had another name.
    std::string render = files::readText(here / "course" / "render.cpp");
    const std::string name = "generatePixelRaysUniform";
    for (std::size_t at = 0; (at = render.find(name, at)) != std::string::npos;)
        render.replace(at, name.size(), "generatePixelRaysMultisampled");
    std::ofstream(folder / "render.cpp") << render;
    return folder;
}

#ifdef RAYWORK_RENDER
fs::path render(const fs::path& with, const std::string& name)
{
    const fs::path picture = workFolder() / name;
    const std::string command = std::string(submission::buildDirectory) + "/framework/raywork-render '"
        + std::string(submission::sourceDirectory) + "/scenes/cornell_box.toml' --size 64x64 --with '" + with.string()
        + "' -o '" + picture.string() + "' > /dev/null";
    REQUIRE(WEXITSTATUS(std::system(command.c_str())) == 0);
    return picture;
}

// Of two pictures of the same size, in [0, 1].
float meanDifference(const fs::path& a, const fs::path& b)
{
    const auto first = files::loadPicture(a);
    const auto second = files::loadPicture(b);
    float sum = 0.0f;
    for (std::size_t i = 0; i < first->pixels.size(); ++i)
        sum += glm::compAdd(glm::abs(first->pixels[i] - second->pixels[i])) / 3.0f;
    return sum / static_cast<float>(first->pixels.size());
}
#endif

}

TEST_CASE("The files of a course student compile, link and are graded unchanged", "[grading]")
{
    const Graded graded = grade(here / "course");
    INFO(graded.printed);
    CHECK(graded.exitCode == 0);
    CHECK(graded.json.at("score").get<double>() >= 99.0); // all but the zero-area triangles
    for (const auto& check : graded.json.at("checks"))
        CHECK(check.at("status") != "refused");
}

TEST_CASE("The files of the first edition compile, link and are graded unchanged", "[grading]")
{
    const Graded graded = grade(firstEdition());
    INFO(graded.printed);
    CHECK(graded.exitCode == 0);
    for (const auto& check : graded.json.at("checks"))
        CHECK(check.at("status") != "refused");
    for (const std::string feature : { "reflection", "transparency", "light", "multisampling" })
        CHECK(graded.lost(feature) == 0.0);
    CHECK(graded.lost("texture") <= 0.5); // its index of a texel is a float, which is too small for large images
}

#ifdef RAYWORK_RENDER
TEST_CASE("A course student's own renderImage makes the picture that ours makes", "[grading]")
{
    const fs::path folder = GENERATE(true, false) ? here / "course" : firstEdition();
    // Their rays start 1e-4 beside ours: some pixels at edges differ.
    CHECK(meanDifference(render(folder, "theirs.png"), render("reference", "ours.png")) < 0.002f);
}
#endif
