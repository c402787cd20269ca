#include "files/digest.h"
#include "files/error.h"
#include "files/temporary_folder.h"
#include "grading/golden_file.h"
#include "grading/live_reference.h"
#include "grading/sealed_file.h"
#include "submission/paths.h"
#include "submission/prune.h"
#include <atomic>
#include <catch2/catch.hpp>
#include <fstream>
#include <thread>

// Where the reference's answers come from, and how they are kept.

namespace fs = std::filesystem;
using files_test::TemporaryFolder;
using worker::Message;

namespace {

Message messageOf(const std::string& text)
{
    Message message;
    message << text;
    return message;
}

std::string textOf(const Message& message)
{
    return worker::Reader(message).read<std::string>();
}

// Answers with the question.
class Echo : public grading::ExpectedAnswers {
public:
    Message answer(const std::string& probe, const Message& input) override
    {
        return messageOf(probe + " of " + textOf(input));
    }
    std::string version() const override { return "echo"; }
};

void changeLastByte(const fs::path& file)
{
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(-1, std::ios::end);
    const char last = static_cast<char>(stream.get());
    stream.seekp(-1, std::ios::end);
    stream.put(static_cast<char>(last ^ 1));
}

void makeNotWhole(const fs::path& file)
{
    const auto size = fs::file_size(file);
    SECTION("empty")
    {
        fs::resize_file(file, 0);
    }
    SECTION("cut off in the seal")
    {
        fs::resize_file(file, 17);
    }
    SECTION("cut off at the end")
    {
        fs::resize_file(file, size - 1);
    }
    SECTION("changed")
    {
        changeLastByte(file);
    }
}

std::vector<fs::path> filesIn(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        files.push_back(entry.path());
    return files;
}

// A question to the reference's worker.
const std::string probe = "texture.sample";

}

TEST_CASE("A sealed file gives back what was written last", "[expected]")
{
    const TemporaryFolder folder;
    CHECK_FALSE(grading::readSealed(folder / "sealed"));
    grading::writeSealed(folder / "sealed", messageOf("first"));
    grading::writeSealed(folder / "sealed", messageOf("second"));
    CHECK(textOf(*grading::readSealed(folder / "sealed")) == "second");
    CHECK(filesIn(folder / "").size() == 1); // no drafts are left
}

TEST_CASE("A sealed file that is not whole is as good as none", "[expected]")
{
    const TemporaryFolder folder;
    grading::writeSealed(folder / "sealed", messageOf("something"));
    makeNotWhole(folder / "sealed");
    CHECK_FALSE(grading::readSealed(folder / "sealed"));
}

TEST_CASE("A golden file gives the answers that were recorded, and no others", "[expected]")
{
    const TemporaryFolder folder;
    Echo echo;
    grading::Recorder recorder { echo };
    for (const char* input : { "a", "b", "a" })
        CHECK(textOf(recorder.answer("echo", messageOf(input))) == std::string("echo of ") + input);
    recorder.write(folder / "golden");

    grading::GoldenFile golden { folder / "golden" };
    CHECK(textOf(golden.answer("echo", messageOf("a"))) == "echo of a");
    CHECK(textOf(golden.answer("echo", messageOf("b"))) == "echo of b");
    CHECK_THROWS_WITH(golden.answer("echo", messageOf("c")),
        Catch::Contains("golden: found no answer of echo") && Catch::Contains("record the file again"));
    CHECK_THROWS_AS(golden.answer("other", messageOf("a")), std::runtime_error);
}

TEST_CASE("A golden file that is not whole is refused by name", "[expected]")
{
    const TemporaryFolder folder;
    Echo echo;
    grading::Recorder(echo).write(folder / "golden");
    makeNotWhole(folder / "golden");
    CHECK_THROWS_WITH(grading::GoldenFile(folder / "golden"), Catch::Contains("golden: found no answers"));
}

namespace {

// A worker that ends at once: whoever gets an answer did not ask it.
fs::path deadWorker(const TemporaryFolder& folder)
{
    const fs::path program = folder.write("worker", "#!/bin/sh\nexit 3\n");
    fs::permissions(program, fs::perms::owner_all);
    return program;
}

// Puts into the folder what the worker would have answered.
void keepAnswer(const TemporaryFolder& folder, const Message& question, const std::string& answer)
{
    const std::string version = files::Digest().addFile(folder / "worker").hex();
    const std::string name = files::Digest().add(version).add(grading::keyOf(probe, question)).hex();
    grading::writeSealed(folder / ("answers/" + name), messageOf(answer));
}

}

TEST_CASE("A live reference does not ask again what it knows", "[expected]")
{
    const TemporaryFolder folder;
    grading::LiveReference reference { deadWorker(folder), folder / "answers" };
    CHECK_THROWS_WITH(reference.answer(probe, messageOf("a")),
        Catch::Contains("the reference's worker, asked for " + probe) && Catch::Contains("exit code 3"));
    keepAnswer(folder, messageOf("a"), "kept");
    CHECK(textOf(reference.answer(probe, messageOf("a"))) == "kept");
    CHECK_THROWS(reference.answer(probe, messageOf("b")));
    SECTION("unless the answer is not whole")
    {
        makeNotWhole(filesIn(folder / "answers").front());
        CHECK_THROWS(reference.answer(probe, messageOf("a")));
    }
    SECTION("unless the worker is another one")
    {
        std::ofstream(folder / "worker", std::ios::app) << "# changed\n";
        grading::LiveReference changed { folder / "worker", folder / "answers" };
        CHECK_THROWS(changed.answer(probe, messageOf("a")));
    }
}

TEST_CASE("Where too much is kept, what was not used for longest goes", "[expected]")
{
    const TemporaryFolder folder;
    const auto now = fs::file_time_type::clock::now();
    for (int age = 0; age < 6; ++age) { // hours
        const fs::path file = folder.write("kept/" + std::to_string(age), "");
        fs::last_write_time(file, now - std::chrono::hours(age + 1));
    }
    submission::noteUse(folder / "kept/5");
    const auto limit = GENERATE(std::size_t(6), std::size_t(5), std::size_t(4));
    submission::prune(folder / "kept", limit);
    for (int age = 0; age < 6; ++age) {
        const int rank = (age + 1) % 6; // by last use
        const std::size_t left = limit == 6 ? 6 : limit / 2;
        CHECK(fs::exists(folder / ("kept/" + std::to_string(age))) == (static_cast<std::size_t>(rank) < left));
    }
}

TEST_CASE("Graders at work at once get whole answers", "[expected]")
{
    const TemporaryFolder folder;
    const std::string text(100'000, 'x');
    std::atomic<int> numBroken = 0;
    {
        std::vector<std::jthread> graders;
        for (int i = 0; i < 4; ++i)
            graders.emplace_back([&] {
                for (int repetition = 0; repetition < 20; ++repetition) {
                    grading::writeSealed(folder / "sealed", messageOf(text));
                    const auto read = grading::readSealed(folder / "sealed");
                    numBroken += !read || textOf(*read) != text;
                }
            });
    }
    CHECK(numBroken == 0);
}
