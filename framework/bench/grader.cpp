#include "bench/grader.h"
#include "files/error.h"
#include "files/text.h"
#include "submission/paths.h"
#include "values/stopwatch.h"
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace bench {
namespace {

    namespace fs = std::filesystem;

    fs::path makeFolder()
    {
        std::string name = fs::temp_directory_path() / "raywork-bench-XXXXXX";
        if (!mkdtemp(name.data()))
            throw std::system_error(errno, std::generic_category(), name);
        return name;
    }

    // Returns its exit code, or -1 if it was killed or could not be started. What it prints goes to a file.
    int runProgram(std::vector<std::string> words, const fs::path& printed)
    {
        std::vector<char*> pointers;
        for (std::string& word : words)
            pointers.push_back(word.data());
        pointers.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(
            &actions, STDOUT_FILENO, printed.c_str(), O_WRONLY | O_CREAT | O_TRUNC, S_IRUSR | S_IWUSR);
        posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
        pid_t process = -1;
        const int error = posix_spawn(&process, words[0].c_str(), &actions, nullptr, pointers.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        int status = 0;
        const bool hasEnded = error == 0 && waitpid(process, &status, 0) == process;
        return hasEnded && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    GradeTimes parseTimes(double total, const fs::path& file)
    {
        const auto json = nlohmann::json::parse(files::readText(file));
        GradeTimes times { total, json.at("building"), json.at("asking"), json.at("drawing"), {} };
        for (const auto& [name, parts] : json.at("files").items())
            times.files[name] = { parts.at("compiling"), parts.at("linking"), parts.at("asking") };
        return times;
    }

}

Grader::Grader(const fs::path& submission)
{
    if (!fs::is_directory(submission))
        throw files::Error(submission, "found no folder, expected a submission's");
    m_folder = makeFolder();
    fs::copy(submission, m_folder / "submission", fs::copy_options::recursive);
    setenv("RAYWORK_CACHE", (m_folder / "cache").c_str(), true);
    setenv("CCACHE_DISABLE", "1", true);
}

Grader::~Grader()
{
    std::error_code gone;
    fs::remove_all(m_folder, gone);
}

GradeTimes Grader::grade() const
{
    const fs::path program = fs::path(submission::buildDirectory) / "grading" / "raywork-grade";
    if (!fs::exists(program))
        throw GraderFailed(
            fmt::format("found no {}, expected the grader: ./raywork bench grade builds it", program.string()));
    const auto in = [&](const char* name) { return (m_folder / name).string(); };
    // A file of JSON would be brought to the disk after each check, and what a disk takes is another question.
    const std::vector<std::string> words { program, in("submission"), "--times", in("times.json"), "--html",
        in("page.html") };
    int exitCode = 0;
    const double seconds = values::secondsOf([&] { exitCode = runProgram(words, in("printed")); });
    if (exitCode != 0)
        throw GraderFailed(fmt::format(
            "the grader failed with exit code {}: {}", exitCode, files::trimmed(files::readText(in("printed")))));
    return parseTimes(seconds, in("times.json"));
}

void Grader::forgetAll() const
{
    fs::remove_all(m_folder / "cache");
}

void Grader::change(const std::string& name)
{
    std::ofstream(m_folder / "submission" / (name + ".cpp"), std::ios::app) << "\n// " << ++m_numChanges << '\n';
}

}
