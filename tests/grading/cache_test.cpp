#include "graded.h"
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sys/wait.h>
#include <unistd.h>

// What is known from an earlier grading is not asked again, and that changes no grade.

namespace {

namespace fs = std::filesystem;

std::string wrongWeight(const std::string& text)
{
    return replaced(text, "    return image.get_pixel(j * image.width + i);",
        "    return 0.9f * image.get_pixel(j * image.width + i);");
}

fs::path changedTexture()
{
    return copyOfReference("texture", wrongWeight);
}

// So that what is known comes from this build and these files alone.
void forgetRows()
{
    fs::remove_all(build / "grading" / "rows");
}

std::size_t numRows()
{
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& row : fs::directory_iterator(build / "grading" / "rows"))
        ++count;
    return count;
}

}

TEST_CASE(
    "After a change of one file, only its checks are repeated, and the grade is that of a fresh grading", "[grading]")
{
    forgetRows();
    const Graded before = grade(copyOfReference("", nullptr));
    const std::size_t all = numRows();
    CHECK(before.json.at("score") == 100);
    CHECK(all == before.json.at("checks").size());

    const fs::path folder = changedTexture();
    const Graded after = grade(folder);
    INFO(after.printed);
    CHECK(numRows()
        == all + static_cast<std::size_t>(after.count("texture", "passed") + after.count("texture", "wrong")));
    CHECK(after.lost("texture") > 0.0);
    CHECK(after.lostElsewhere("texture") == 0.0);

    const Graded fresh = grade(folder, "--fresh");
    CHECK(fresh.json.at("checks") == after.json.at("checks"));
    CHECK(grade(folder).json.at("checks") == after.json.at("checks"));
}

TEST_CASE("A row that is not whole is asked for again", "[grading]")
{
    forgetRows();
    const Graded before = grade(changedTexture(), "--only texture");
    for (const auto& row : fs::directory_iterator(build / "grading" / "rows"))
        fs::resize_file(row, fs::file_size(row) / 2);
    CHECK(grade(changedTexture(), "--only texture").json.at("checks") == before.json.at("checks"));
}

TEST_CASE("What was drawn is kept by content, and not asked again", "[grading]")
{
    const fs::path drawings = build / "grading" / "drawings";
    const auto drawingOf = [&](const fs::path& folder) {
        fs::remove_all(drawings);
        const Graded graded = grade(folder, "--only reflection");
        CHECK(graded.json.at("observations").at("reflection").at("drawn").size() > 1);
        REQUIRE(std::distance(fs::directory_iterator(drawings), {}) == 1);
        return fs::directory_iterator(drawings)->path();
    };
    const auto inBlue = [](const std::string& text) {
        return replaced(text, "glm::vec3(1.0f, 1.0f, 0.0f)", "glm::vec3(0.0f, 0.0f, 1.0f)");
    };
    fs::rename(drawingOf(copyOfReference("recursive", inBlue)), build / "grading" / "blue");
    const fs::path reference = copyOfReference("", nullptr);
    fs::rename(build / "grading" / "blue", drawingOf(reference)); // an answer that only who does not ask takes for it
    const auto line = [&](const std::string& options) {
        const Graded graded = grade(reference, "--only reflection " + options);
        return graded.json.at("observations").at("reflection").at("drawn").at(0).get<std::string>();
    };
    CHECK(line("") == "2 rays along the normal, (0, 0, 1), 0.2 long");
    CHECK(line("--fresh") == "2 rays along the normal, yellow, 0.2 long");
    fs::remove_all(drawings);
}

TEST_CASE("RAYWORK_CACHE names a folder in which all is kept, and the grade is the same", "[grading]")
{
    const fs::path folder = changedTexture(), own = workFolder() / "own cache";
    forgetRows();
    const Graded usual = grade(folder, "--only texture");
    const std::size_t before = numRows();
    const Graded elsewhere = grade(folder, "--only texture", "RAYWORK_CACHE='" + own.string() + "' ");
    CHECK(elsewhere.json == usual.json);
    CHECK(numRows() == before);
    for (const char* kept : { "submissions", "grading/rows", "grading/answers" })
        CHECK_FALSE(fs::is_empty(own / kept));
}

TEST_CASE("Of a file that was asked about, the seconds are written that it took to build and to ask", "[grading]")
{
    const fs::path file = workFolder() / "times.json";
    const Graded graded
        = grade(copyOfReference("", nullptr), "--fresh --only reflection --times '" + file.string() + "'");
    REQUIRE(graded.exitCode == 0);
    const nlohmann::json times = nlohmann::json::parse(std::ifstream(file));
    REQUIRE(times.at("files").size() == 1);
    const auto& recursive = times.at("files").at("recursive");
    CHECK(recursive.at("compiling") > 0.0);
    CHECK(recursive.at("linking") > 0.0);
    CHECK(recursive.at("asking") > 0.0);
    CHECK(times.at("building") >= recursive.at("compiling").get<double>() + recursive.at("linking").get<double>());
    CHECK(times.at("asking") > 0.0);
    CHECK(times.at("drawing") > 0.0);
}

TEST_CASE("A folder that is watched is graded again at each change", "[grading]")
{
    const fs::path folder = copyOfReference("", nullptr);
    const fs::path json = build / "tests" / "watched.json";
    fs::remove(json);
    const pid_t watcher = fork();
    if (watcher == 0) {
        if (!std::freopen("/dev/null", "w", stdout))
            _exit(126);
        const std::string program = build / "grading" / "raywork-grade";
        execl(program.c_str(), program.c_str(), folder.c_str(), "--only", "texture", "--watch", "--json", json.c_str(),
            nullptr);
        _exit(127);
    }
    // A file appears whole, so whatever is read is a grade.
    const auto waitForScore = [&](bool isFull) {
        waitUntil([&] {
            std::ifstream file(json);
            const auto grade = file ? nlohmann::json::parse(file) : nlohmann::json();
            return grade.is_object() && grade.at("complete") == true && (grade.at("score") == 10.0) == isFull;
        });
    };
    waitForScore(true);
    const fs::path texture = folder / "texture.cpp";
    std::ifstream file(texture);
    const std::string right { std::istreambuf_iterator<char>(file), {} };
    std::ofstream(texture) << wrongWeight(right);
    waitForScore(false);
    std::ofstream(texture) << right;
    waitForScore(true);
    kill(watcher, SIGTERM);
    int status = 0;
    waitpid(watcher, &status, 0);
    CHECK(WIFSIGNALED(status));
}
