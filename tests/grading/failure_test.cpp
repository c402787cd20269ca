#include "graded.h"
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

// When the grader itself fails it says so, with exit code 75, and no grade that looks whole is left.

namespace {

namespace fs = std::filesystem;

const fs::path reference = root / "reference";

fs::path freshFolder(const std::string& name)
{
    const fs::path folder = build / "tests" / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

std::string readText(const fs::path& path)
{
    std::ifstream file(path);
    return { std::istreambuf_iterator<char>(file), {} };
}

struct Ended {
    int exitCode = 0;
    std::string printed;
};

Ended waitFor(pid_t process, const fs::path& printed)
{
    int status = 0;
    REQUIRE(waitpid(process, &status, 0) == process);
    REQUIRE(WIFEXITED(status));
    return { WEXITSTATUS(status), readText(printed) };
}

pid_t start(std::vector<std::string> words, const fs::path& printed)
{
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const pid_t process = fork();
    if (process == 0) {
        const std::string path = printed.string();
        if (!std::freopen(path.c_str(), "w", stdout) || dup2(STDOUT_FILENO, STDERR_FILENO) < 0)
            _exit(126);
        execvp(pointers[0], pointers.data());
        _exit(127);
    }
    return process;
}

std::vector<std::string> graderWords(const fs::path& submission, const fs::path& json)
{
    return { (build / "grading" / "raywork-grade").string(), submission.string(), "--json", json.string(), "--fresh" };
}

// The grader where a folder is a disk of its own, with so much room.
std::vector<std::string> withSmallDisk(const fs::path& folder, std::size_t bytes, const std::vector<std::string>& words)
{
    std::vector<std::string> all { "bwrap", "--dev-bind", "/", "/", "--size", std::to_string(bytes), "--tmpfs",
        folder.string(), "--" };
    all.insert(all.end(), words.begin(), words.end());
    return all;
}

void expectFailure(const Ended& ended, const std::string& why)
{
    INFO(ended.printed);
    CHECK(ended.exitCode == 75);
    CHECK_THAT(ended.printed, Catch::Contains("the grader failed: ") && Catch::Contains(why));
    CHECK_THAT(ended.printed, !Catch::Contains("total"));
}

void expectNothingWhole(const fs::path& json)
{
    if (fs::exists(json))
        CHECK(nlohmann::json::parse(readText(json)).at("complete") == false);
}

// The one child of a process, as soon as it has one.
pid_t childOf(pid_t process)
{
    const fs::path children
        = fs::path("/proc") / std::to_string(process) / "task" / std::to_string(process) / "children";
    std::string found;
    waitUntil([&] { return !(found = readText(children)).empty(); });
    return std::stoi(found);
}

}

TEST_CASE("A reference that dies ends the grading", "[grading]")
{
    const fs::path folder = freshFolder("dying_reference");
    std::ofstream(folder / "grade.json") << R"({"complete": true, "score": 100})";
    std::vector<std::string> words = graderWords(reference, folder / "grade.json");
    words.insert(words.end(), { "--reference-worker", "/usr/bin/false" });
    const fs::path printed = folder / "printed.txt";
    expectFailure(waitFor(start(words, printed), printed), "the reference's worker");
    expectNothingWhole(folder / "grade.json");
}

TEST_CASE("A grader that is killed says so and leaves an incomplete grade", "[grading]")
{
    const fs::path folder = freshFolder("killed");
    const fs::path json = folder / "grade.json";
    // Busy for seconds, with rows before.
    const fs::path submission = copyOfReference("texture", [](const std::string& text) {
        return replaced(text, "    return image.get_pixel(j * image.width + i);",
            "    for (volatile bool forever = true; forever;) { }\n    return {};");
    });
    const fs::path printed = folder / "printed.txt";
    const pid_t supervisor = start(graderWords(submission, json), printed);
    const auto numRows = [&] { return nlohmann::json::parse(readText(json)).at("checks").size(); };
    waitUntil([&] { return fs::exists(json) && numRows() > 0; });
    SECTION("by somebody who kills the process that grades")
    {
        kill(childOf(supervisor), SIGKILL);
    }
    SECTION("by somebody who interrupts it")
    {
        kill(supervisor, SIGINT);
    }
    SECTION("by a machine that is shut down")
    {
        kill(supervisor, SIGTERM);
    }
    expectFailure(waitFor(supervisor, printed), "it was ended by");
    REQUIRE(fs::exists(json));
    expectNothingWhole(json);
}

TEST_CASE("A disk without room for the grade ends the grading", "[grading]")
{
    const fs::path folder = freshFolder("full_disk");
    const fs::path disk = freshFolder("full_disk/disk");
    const fs::path printed = folder / "printed.txt";
    const auto words = withSmallDisk(disk, 4096, graderWords(reference, disk / "grade.json"));
    expectFailure(waitFor(start(words, printed), printed), "cannot be written");
}

TEST_CASE("A disk without room to compile ends the grading, and is nobody's mistake", "[grading]")
{
    const fs::path folder = freshFolder("full_build_disk");
    const fs::path printed = folder / "printed.txt";
    const auto words = withSmallDisk(build / "submissions", 300'000, graderWords(reference, folder / "grade.json"));
    expectFailure(waitFor(start(words, printed), printed), "is full");
    expectNothingWhole(folder / "grade.json");
}
