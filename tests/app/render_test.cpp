#include "app/rendered.h"
#include "debug/false_color.h"
#include "files/picture.h"
#include "submission/paths.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

// The renderer as it is called.

namespace fs = std::filesystem;
using namespace rendered;

namespace {

const std::string scenes = std::string(submission::sourceDirectory) + "/scenes/";

std::string sceneFile(const std::string& text)
{
    fs::create_directories(work);
    const fs::path path = work / "scene.toml";
    std::ofstream(path) << text;
    return path.string();
}

// Its bytes. with: student, or a submission's folder.
std::string smallPicture(const std::string& scene, const fs::path& with, const std::string& setting)
{
    const std::string output = (work / "small.exr").string();
    const Outcome outcome = render("'" + scene + "' --size 24x18 --with '" + with.string() + "' -o '" + output
        + "' --set reflections=true --set transparency=true --set " + setting);
    REQUIRE(outcome.exitCode == 0);
    // The file says when it was made.
    return std::regex_replace(bytesOf(output), std::regex(R"(\d{4}:\d\d:\d\d \d\d:\d\d:\d\d)"), "");
}

}

TEST_CASE("Bad input to render ends with exit code 2 and one line that says where", "[render]")
{
    struct Case {
        std::string text, arguments, found; // text: of a scene file, where the arguments name none
    };
    const Case c = GENERATE(values<Case>({
        { "size = [0, 0]\n", "", "scene.toml:1: " },
        { "\nlights = 3\n", "", "scene.toml:2: found the unknown key \"lights\"" },
        { "", "no_such_scene.toml", "no_such_scene.toml: " },
        { "", scenes + "cube.toml --set shadow=true", "unknown feature \"shadow\"" },
        { "", scenes + "cube.toml --set shadows", "expected feature=value" },
        { "", scenes + "cube.toml --size 0x10", "expected WIDTHxHEIGHT" },
        { "", scenes + "cube.toml --debug-ray 5", "--debug-ray: found '5', expected X,Y" },
        { "", scenes + "cube.toml --size 9x9 --debug-ray 9,0",
            "found the pixel 9,0, expected one of a picture of 9 x 9" },
        { "", scenes + "cube.toml --orbit up", "--orbit: found 'up', expected X,Y" },
        { "", scenes + "cube.toml --show norm", "found the quantity 'norm', expected one of color, normal, " },
        { "", scenes + "cube.toml --error 0", "--error: found '0', expected a number above 0, at most 1" },
        { "", scenes + "cube.toml --error 2", "--error: found '2', expected a number above 0, at most 1" },
        { "", scenes + "cube.toml --error 1%", "--error: found '1%', expected a number" },
        { "", scenes + "cube.toml --error nan", "--error: found 'nan', expected a number" },
        { "", scenes + "cube.toml --time -1", "--time: found '-1', expected a number above 0" },
        { "", scenes + "cube.toml --time soon", "--time: found 'soon', expected a number above 0" },
        { "", scenes + "cube.toml --error 0.1 --set motion_blur=true", "found the feature motion_blur" },
        { "", scenes + "cube.toml --with no_such_folder", "no_such_folder: found no folder" },
    }));
    INFO(c.text << c.arguments);
    const std::string arguments = c.arguments.empty() ? sceneFile(c.text) : c.arguments;
    const Outcome outcome = render(arguments + " -o '" + (work / "none.png").string() + "'");
    CHECK(outcome.exitCode == 2);
    CHECK_THAT(outcome.errors, Catch::Contains(c.found));
    CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
    CHECK_FALSE(fs::exists(work / "none.png"));
}

TEST_CASE("A picture has the size asked for, and the same bytes for any number of threads", "[render]")
{
    const std::string arguments
        = scenes + "cornell_box_parallelogram_light.toml --size 48x32 --samples 4 --stratified -o '";
    REQUIRE(render(arguments + (work / "one.png").string() + "' --threads 1").exitCode == 0);
    REQUIRE(render(arguments + (work / "many.png").string() + "'").exitCode == 0);
    CHECK(bytesOf(work / "one.png") == bytesOf(work / "many.png"));
    const auto picture = files::loadPicture(work / "one.png");
    CHECK(picture->width == 48);
    CHECK(picture->height == 32);
}

TEST_CASE("A picture to an error says what it took and what it believes, and is the same for any number of threads",
    "[render]")
{
    const std::string arguments = scenes + "cornell_box_parallelogram_light.toml --size 48x32 --error 0.02 -o '";
    const Outcome one = render(arguments + (work / "one.png").string() + "' --threads 1");
    REQUIRE(one.exitCode == 0);
    CHECK_THAT(one.output, Catch::Contains(" samples a pixel, 8 to "));
    CHECK_THAT(one.output, Catch::Contains("its error is believed to be 0.0"));
    REQUIRE(render(arguments + (work / "many.png").string() + "'").exitCode == 0);
    CHECK(bytesOf(work / "one.png") == bytesOf(work / "many.png"));

    const Outcome both = render(arguments + (work / "one.png").string() + "' --samples 4");
    CHECK(both.exitCode == 2);
    CHECK_THAT(both.errors, Catch::Contains("excludes"));
}

TEST_CASE("A picture in a limited time is done, by code that is not written yet, too", "[render]")
{
    const std::string arguments = scenes + "cornell_box.toml --size 16x16 --with student --time 0.1 -o '";
    const Outcome outcome = render(arguments + (work / "timed.png").string() + "'");
    CHECK(outcome.exitCode == 0);
    CHECK_THAT(outcome.output, Catch::Contains("8.0 samples a pixel, 8 to 8; its error is believed to be 0"));
}

TEST_CASE("The stubs render every scene's silhouette from day one", "[render]")
{
    const Outcome outcome
        = render(scenes + "cornell_box.toml --with student --size 32x32 -o '" + (work / "student.png").string() + "'");
    CHECK(outcome.exitCode == 0);
    CHECK_THAT(outcome.errors, Catch::Contains("computeContributionPointLight is not written yet"));
    const auto picture = files::loadPicture(work / "student.png");
    float sum = 0.0f;
    for (std::size_t i = 0; i < picture->pixels.size(); ++i)
        sum += picture->pixels[i].r;
    CHECK(sum / static_cast<float>(picture->pixels.size()) > 0.05f); // something is to be seen
}

TEST_CASE("An OpenEXR picture can be written, a JPEG cannot", "[render]")
{
    const std::string arguments = scenes + "cube.toml --size 8x8 --samples 1 -o '";
    CHECK(render(arguments + (work / "cube.exr").string() + "'").exitCode == 0);
    CHECK(bytesOf(work / "cube.exr").substr(0, 4) == "\x76\x2f\x31\x01"); // the magic number of OpenEXR
    CHECK(render(arguments + (work / "cube.jpg").string() + "'").exitCode == 2);
}

TEST_CASE("Normals are shown as colours, and numbers with their range", "[render]")
{
    // The camera looks down at a floor.
    const std::string scene = sceneFile("size = [8, 8]\n[camera]\nlook_at = [0, 0, 0]\nrotation = [30, 0, 0]\n"
                                        "distance = 2\n[[mesh]]\nshape = \"cube\"\nscale = 9\n"
                                        "translate = [0, -6, 0]\n");
    const std::string output = (work / "shown.png").string();
    const Outcome normals = render(scene + " --show normal -o '" + output + "'");
    REQUIRE(normals.exitCode == 0);
    CHECK_THAT(normals.output, !Catch::Contains("from"));
    const auto up = files::loadPicture(output)->get_pixel(0); // the nearest
    constexpr float halfStep = 0.5f / 255.0f + 1e-6f; // of eight bits, and rounding
    CHECK(up.x == Approx(0.5f).margin(halfStep));
    CHECK(up.y == 1.0f);
    CHECK(up.z == up.x);

    const Outcome samples = render(scene + " --show samples --samples 9 -o '" + output + "'");
    REQUIRE(samples.exitCode == 0);
    CHECK_THAT(samples.output, Catch::Contains("samples from 0 to 9\n"));
    const glm::vec3 shown = files::loadPicture(output)->get_pixel(0), most = debug::heat(1.0f);
    CHECK(glm::all(glm::lessThanEqual(glm::abs(shown - most), glm::vec3(halfStep))));
}

TEST_CASE("A file name is never a command", "[render]")
{
    const fs::path folder = work / "named";
    fs::create_directories(folder / "extra");
    std::ofstream(folder / "extra" / "a; touch broken; .cpp") << "int x;\n";
    const Outcome outcome = render(scenes + "cube.toml --size 8x8 --samples 1 --with '" + folder.string() + "' -o '"
        + (work / "named.png").string() + "'");
    CHECK(outcome.exitCode == 0);
    CHECK_THAT(outcome.errors, Catch::Contains("its name has characters other than"));
}

TEST_CASE("A debug ray has the same shapes as SVG and as JSON, and the PNG shows them", "[render]")
{
    const std::string arguments
        = scenes + "cornell_box.toml --size 80x80 --debug-ray 40,24 --orbit 20,50 -o '" + (work / "ray").string();
    for (const std::string extension : { ".svg", ".json", ".png" })
        REQUIRE(render(arguments + extension + "'").exitCode == 0);
    const auto json = nlohmann::json::parse(bytesOf(work / "ray.json"));
    const std::string svg = bytesOf(work / "ray.svg");
    std::set<std::size_t> drawn;
    for (std::size_t at = 0; (at = svg.find("data-shape=\"", at)) != svg.npos; ++at)
        drawn.insert(std::stoul(svg.substr(at + 12)));
    CHECK(drawn.size() == json.at("shapes").size()); // none lies behind the camera
    CHECK(*drawn.rbegin() == json.at("shapes").size() - 1);

    std::map<std::string, int> types;
    for (const auto& shape : json.at("shapes"))
        ++types[shape.at("type").get<std::string>()];
    CHECK(types["box"] > 3);
    CHECK(types["triangle"] >= 1);
    CHECK(types["ray"] >= 2);
    CHECK(json.at("hits").at(0).at("bounce") == 0);
    CHECK(json.at("samples").size() == 1);
    CHECK(json.at("samples").at(0).at(0).get<double>() == Approx(0.5).margin(1e-3));

    const auto picture = files::loadPicture(work / "ray.png");
    const auto isYellow = [&](std::size_t i) { // the first box
        const glm::vec3 color = picture->pixels[i];
        return color.r > 0.9f && color.g > 0.9f && color.b < 0.1f;
    };
    std::size_t numYellow = 0;
    for (std::size_t i = 0; i < picture->pixels.size(); ++i)
        numYellow += isYellow(i);
    CHECK(numYellow > 10); // what later boxes have left of it
}

TEST_CASE("The texels of a lookup are told with their weights", "[render]")
{
    const std::string output = (work / "texels.json").string();
    const std::string bilinear = " --set texture_mapping=true --set bilinear_filtering=true";
    REQUIRE(render(scenes + "cube_textured.toml --size 80x80 --debug-ray 40,40 -o '" + output + "'" + bilinear).exitCode
        == 0);
    const auto lookups = nlohmann::json::parse(bytesOf(output)).at("lookups");
    REQUIRE(lookups.size() == 1);
    double sum = 0.0;
    for (const auto& texel : lookups.at(0).at("texels"))
        sum += texel.at("weight").get<double>();
    CHECK(sum == Approx(1.0).margin(1e-4)); // what is below that is left out
    CHECK(lookups.at(0).at("texels").size() == 4);
}

TEST_CASE("What is skipped changes no pixel, whoever wrote the code", "[render]")
{
    const fs::path folder(submission::sourceDirectory);
    const fs::path with = GENERATE_COPY(values<fs::path>(
        { "student", folder / "tests" / "grading" / "course", folder / "tests" / "grading" / "course_2023" }));
    const std::string scene = GENERATE(values<std::string>({ "cornell_box", "transparent_shadows", "soft_shadows" }));
    const std::string file = scenes + scene + ".toml";
    CHECK(smallPicture(file, with, "skipping=true") == smallPicture(file, with, "skipping=false"));
}

TEST_CASE("Whoever gives surfaces colours of their own is asked for them, also where no texture is", "[render]")
{
    const fs::path reference = fs::path(submission::sourceDirectory) / "reference", own = work / "own colours";
    fs::create_directories(own);
    fs::copy(reference, own, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    std::ofstream(own / "shading.cpp", std::ios::app)
        << "glm::vec3 sampleMaterialKd(RenderState&, const HitInfo&) { return glm::vec3(0.25f, 0.5f, 0.75f); }\n";
    const std::string scene = sceneFile("[camera]\nlook_at = [0, 0, 0]\nrotation = [90, 0, 0]\ndistance = 1\n"
                                        "field_of_view = 45\n\n[features]\nshading = true\n\n"
                                        "[[mesh]]\nquads = [[[-9, 0, -9], [-9, 0, 9], [9, 0, 9], [9, 0, -9]]]\n"
                                        "kd = [0, 0, 0]\n\n"
                                        "[[light]]\ntype = \"point\"\nposition = [0, 1, 0]\ncolor = [1, 1, 1]\n");
    for (const std::string& file : { scene, scenes + "cornell_box.toml" }) {
        CHECK(smallPicture(file, own, "skipping=true") == smallPicture(file, own, "skipping=false"));
        CHECK(smallPicture(file, own, "skipping=true") != smallPicture(file, reference, "skipping=true"));
    }
}

TEST_CASE("What a picture needs is explained, with why the rest is left out", "[render]")
{
    const Outcome outcome = render(scenes + "cornell_box.toml --size 24x18 --explain --set transparency=true");
    CHECK(outcome.exitCode == 0);
    for (const std::string line : { "triangles  *yes", "spheres  *no: the scene has none", "mirrors  *yes",
             "transparency  *no: every material is opaque", "light from behind  *no: ", "rays from the camera  *432",
             "rays to lights, left out  *[1-9]", "textures decoded  *0 of 0" })
        CHECK(std::regex_search(outcome.output, std::regex(line)));
}
