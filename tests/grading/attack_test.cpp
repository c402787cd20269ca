#include "files/digest.h"
#include "graded.h"
#include <catch2/catch.hpp>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <sys/prctl.h>
#include <sys/wait.h>

// Submissions that would rather beat the grader than the exercise: each is graded as a whole folder, the reference but
// for one file. See attack/.

namespace {

namespace fs = std::filesystem;

std::string replaceAll(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

// An attack, ready to be compiled: some are a whole file, most a function that both lookups of texture.cpp call.
struct Attack {
    std::string file; // of the submission, without .cpp; the feature's name as well
    std::string status; // that it must end with
    std::string text;
};

Attack readAttack(const std::string& name)
{
    std::ifstream in(root / "tests" / "grading" / "attack" / (name + ".cpp"));
    std::string text { std::istreambuf_iterator<char>(in), {} };
    REQUIRE(text.starts_with("// "));
    const std::string status = text.substr(3, text.find(':') - 3);
    text = replaceAll(replaceAll(text, "@SOURCE@", root.string()), "@BUILD@", build.string());
    if (name.starts_with("bvh_"))
        return { "bvh", status, text };
    if (text.find("sampleTextureNearest") != text.npos)
        return { "texture", status, text };
    const std::string lookup = "(const Image&, const glm::vec2&) { return attack(); }\n";
    return { "texture", status,
        "#include \"texture.h\"\n" + text + "glm::vec3 sampleTextureNearest" + lookup
            + "glm::vec3 sampleTextureBilinear" + lookup };
}

// All that a grade is made by.
std::string digestOfGrader()
{
    files::Digest digest;
    for (const char* folder : { "framework", "grading", "reference", "scenes" })
        digest.addFolder(root / folder);
    for (const char* program : { "raywork-grade", "reference-worker" })
        digest.addFile(build / "grading" / program);
    return digest.addFile(build / "rules.toml").hex();
}

// Orphans become our children: is any of them alive?
bool isAnyoneLeft()
{
    pid_t ended = 0;
    while ((ended = waitpid(-1, nullptr, WNOHANG)) > 0) { }
    return ended == 0;
}

// What attacks would leave where anybody may write, and beside the grader.
bool isAnythingLeft()
{
    for (const fs::path& folder : { fs::path("/tmp"), fs::path("/var/tmp"), fs::path("/dev/shm"), build, root })
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            if (const auto name = entry.path().filename().string();
                name.starts_with("raywork-fill-") || name == "grade.json")
                return true;
    return fs::exists(build / "grading" / "grade.json");
}

void expectHarmless(const fs::path& folder, const std::string& feature, const std::string& status,
    const std::string& options = "--sandbox required")
{
    REQUIRE(prctl(PR_SET_CHILD_SUBREAPER, 1) == 0);
    const std::string before = digestOfGrader();
    const Graded graded = grade(folder, options);
    INFO(graded.printed);
    CHECK(graded.exitCode == 0);
    CHECK_FALSE(isAnyoneLeft());
    CHECK_FALSE(isAnythingLeft());
    CHECK(digestOfGrader() == before);
    REQUIRE(graded.json.is_object());
    CHECK(graded.json.at("checks").size() > 100);
    CHECK(graded.json.at("features").at(feature).at("score") == 0.0);
    CHECK(graded.lostElsewhere(feature) == 0.0);
    for (const auto& check : graded.json.at("checks"))
        if (check.at("feature") == feature) {
            INFO(check.at("name") << ": " << check.at("message"));
            CHECK(check.at("status") == status);
            const auto message = check.at("message").get<std::string>();
            CHECK((message.find("found ") == std::string::npos || message.find("found nothing") != std::string::npos));
            CHECK(message.find('\x1b') == std::string::npos);
            CHECK(message.find("\xc2\x9b") == std::string::npos);
        }
}

fs::path folderWithout(const std::string& file)
{
    const fs::path folder = copyOfReference("", nullptr);
    fs::remove(folder / (file + ".cpp"));
    return folder;
}

}

// One of attack/, named by the environment, so that each is a test of its own.
TEST_CASE("An attack scores nothing and leaves nothing behind", "[.attack]")
{
    const char* const name = std::getenv("RAYWORK_ATTACK");
    REQUIRE(name);
    const Attack attack = readAttack(name);
    expectHarmless(
        copyOfReference(attack.file, [&](const std::string&) { return attack.text; }), attack.file, attack.status);
}

TEST_CASE("Without Bubblewrap, processes are still neither started nor killed, and nothing is endless", "[grading]")
{
    const std::string name = GENERATE("fork_bomb", "detached_grandchild", "killed_parent", "network", "endless_loop",
        "endless_output", "much_memory");
    const Attack attack = readAttack(name);
    INFO(name);
    expectHarmless(copyOfReference(attack.file, [&](const std::string&) { return attack.text; }), attack.file,
        attack.status, "--sandbox off");
}

TEST_CASE("A grade says whether the submission was locked in, or is refused", "[grading]")
{
    const fs::path folder = root / "reference";
    const std::string nowhere = "PATH=/nowhere ";
    const Graded grudging = grade(folder, "--only texture", nowhere);
    INFO(grudging.printed);
    CHECK(grudging.exitCode == 0);
    CHECK_THAT(grudging.printed, Catch::Contains("not sandboxed: bubblewrap is not installed"));
    CHECK(grudging.json.at("sandbox") == "none: bubblewrap is not installed");
    CHECK(grudging.json.at("score") == 10);

    const Graded refused = grade(folder, "--only texture --sandbox required", nowhere);
    INFO(refused.printed);
    CHECK(refused.exitCode == 75);
    CHECK(refused.printed == "the grader failed: --sandbox required: bubblewrap is not installed\n");
    CHECK(refused.json.is_null());

    CHECK(grade(folder, "--only texture --sandbox required").json.at("sandbox") == "bubblewrap");
}

TEST_CASE("A link to the solution is refused", "[grading]")
{
    const fs::path folder = folderWithout("texture");
    fs::create_symlink(root / "reference" / "texture.cpp", folder / "texture.cpp");
    expectHarmless(folder, "texture", "refused");
}

TEST_CASE("A folder that is a link to another is no folder of a submission", "[grading]")
{
    const fs::path folder = folderWithout("texture");
    fs::create_directory_symlink(root / "reference", folder / "extra");
    fs::create_directory(folder / "texture.cpp");
    expectHarmless(folder, "texture", "refused");
}

TEST_CASE("Files that are called like options of a compiler are words to nobody", "[grading]")
{
    const fs::path folder = folderWithout("texture");
    fs::create_directory(folder / "extra");
    for (const char* name : { "-o", "-o.cpp", "-fplugin=x.cpp", "extra/-o.cpp", "extra/$(touch x).cpp", "extra/;.cpp" })
        std::ofstream(folder / name) << "int x;\n";
    expectHarmless(folder, "texture", "not attempted");
}

TEST_CASE("A source of a gigabyte is refused unread", "[grading]")
{
    const fs::path folder = folderWithout("texture");
    std::ofstream(folder / "texture.cpp") << "\n";
    fs::resize_file(folder / "texture.cpp", std::uintmax_t(1) << 30);
    expectHarmless(folder, "texture", "refused");
}

TEST_CASE("Answers learnt by heart are worth nothing with another secret", "[grading]")
{
    // What a check asks first, as the exception of a spy tells who knows the seed.
    const auto spy = [](const std::string&) {
        return std::string(R"(#include "texture.h"
#include <stdexcept>
[[noreturn]] static void tell(const glm::vec2& uv) { throw std::runtime_error("asked " + std::to_string(uv.x)); }
glm::vec3 sampleTextureNearest(const Image&, const glm::vec2& uv) { tell(uv); }
glm::vec3 sampleTextureBilinear(const Image&, const glm::vec2& uv) { tell(uv); }
)");
    };
    const fs::path secret = workFolder() / "secret";
    std::ofstream(secret) << "sixteen bytes or more, that nobody knows";
    const fs::path folder = copyOfReference("texture", spy);
    const auto askedFirst = [&](const std::string& options) {
        const Graded graded = grade(folder, "--only texture " + options);
        INFO(graded.printed);
        return graded.json.at("checks").at(0).at("message").get<std::string>();
    };
    const std::string known = askedFirst("--seed 1");
    CHECK_THAT(known, Catch::Contains("asked 0."));
    CHECK(askedFirst("--seed 1 --fresh") == known);
    CHECK(askedFirst("--seed 2") != known);
    CHECK(askedFirst("--secret-file '" + secret.string() + "'") != known);
    // Nor does another submission get the same questions.
    std::ofstream(folder / "texture.cpp", std::ios::app) << "// mine\n";
    CHECK(askedFirst("--seed 1") != known);
}
