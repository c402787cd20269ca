#include "submission/submission.h"
#include "submission/includes.h"
#include "submission/paths.h"
#include "submission/sources.h"
#include <algorithm>
#include <fmt/format.h>
#include <initializer_list>
#include <sstream>
#include <stdexcept>

namespace submission {
namespace {

    namespace fs = std::filesystem;

    constexpr int maxMessageLines = 12;
    const std::string wholeProgram = "worker";

    // A folder of its own for each folder of a submission.
    fs::path workFolder(const fs::path& directory)
    {
        const std::string path = fs::weakly_canonical(directory).string();
        const fs::path folder
            = fs::path(buildDirectory) / "submissions" / fmt::format("{:016x}", std::hash<std::string> {}(path));
        fs::create_directories(folder);
        return folder;
    }

    std::string objectOf(const std::string& name)
    {
        return "obj/" + name + ".o";
    }

    bool holdsAny(const std::string& line, std::initializer_list<const char*> words)
    {
        return std::any_of(words.begin(), words.end(), [&](const char* word) { return line.find(word) != line.npos; });
    }

    // The lines of a compiler's output from the first error on.
    std::string compilerErrors(const std::string& log)
    {
        std::istringstream lines(log);
        std::string errors;
        int count = 0;
        for (std::string line; std::getline(lines, line) && count < maxMessageLines;)
            if (count > 0 || holdsAny(line, { "error" }))
                errors += line + "\n", ++count;
        return errors.empty() ? "took more than a minute to compile\n" : errors;
    }

    // The lines that hold any of the words.
    std::string linesWith(std::initializer_list<const char*> words, const std::string& log)
    {
        std::istringstream lines(log);
        std::string found;
        int count = 0;
        for (std::string line; std::getline(lines, line) && count < maxMessageLines;)
            if (holdsAny(line, words))
                found += line + "\n", ++count;
        return found;
    }

    // What a linker found missing or twice.
    std::string linkerErrors(const std::string& log)
    {
        const std::string errors = linesWith({ "undefined reference", "multiple definition" }, log);
        return errors.empty() ? log.substr(0, 1000) : errors;
    }

}

Submission::Submission(const fs::path& directory)
    : m_work(workFolder(directory))
    , m_lock(m_work)
    , m_parts(takeSources(directory, m_work))
    , m_ninja(m_work)
{
    for (const auto& [name, part] : m_parts)
        if (part.state == State::Taken)
            m_ninja.addCompile(objectOf(name), name + ".cpp");
}

void Submission::buildFeatureWorkers(const std::vector<std::string>& features)
{
    std::vector<std::string> wanted;
    for (const std::string& feature : features) {
        const State state = m_parts.at(feature).state;
        if (state == State::Refused)
            continue;
        const std::vector<std::string> own
            = state == State::Missing ? std::vector<std::string> {} : std::vector { objectOf(feature) };
        m_programs[feature] = "worker-" + feature;
        m_ninja.addLink(m_programs[feature], own, "rest_" + feature);
        wanted.push_back(m_programs[feature]);
    }
    m_ninja.build(wanted);
    for (const auto& [feature, program] : m_programs) {
        noteCompiled(feature);
        if (m_parts.at(feature).state != State::Refused && !m_ninja.succeeded(program))
            linkWithOthers(feature);
    }
}

// A file may use functions of the submission's other files. Then it is tried together with all of them.
void Submission::linkWithOthers(const std::string& feature)
{
    const std::string alone = m_programs.at(feature);
    compileAll();
    m_programs[feature] = alone + "-and-others";
    m_ninja.addLink(m_programs[feature], builtObjects(), "rest_questioned");
    m_ninja.build({ m_programs[feature] });
    if (!m_ninja.succeeded(m_programs[feature]))
        m_parts.at(feature) = { State::Refused, linkerErrors(m_ninja.log(alone)), "" };
}

void Submission::buildWholeWorker()
{
    compileAll();
    m_ninja.addLink(wholeProgram, builtObjects(), "rest_whole");
    m_ninja.build({ wholeProgram });
    if (!m_ninja.succeeded(wholeProgram))
        throw std::runtime_error(linkerErrors(m_ninja.log(wholeProgram)));
}

void Submission::compileAll()
{
    std::vector<std::string> objects;
    for (const auto& [name, part] : m_parts)
        if (part.state == State::Taken)
            objects.push_back(objectOf(name));
    m_ninja.build(objects);
    for (const auto& [name, part] : m_parts)
        noteCompiled(name);
}

void Submission::noteCompiled(const std::string& name)
{
    Part& part = m_parts.at(name);
    if (part.state != State::Taken)
        return;
    const std::string log = m_ninja.log(objectOf(name));
    const std::string foreign = firstForeignInclude(m_ninja.dependencies(objectOf(name)));
    if (!foreign.empty())
        part = { State::Refused, name + ".cpp includes " + foreign + ", which is not part of the interface\n", "" };
    else if (m_ninja.succeeded(objectOf(name)))
        part = { State::Built, "", linesWith({ "no previous declaration" }, log) };
    else
        part = { State::Refused, compilerErrors(log), "" };
}

std::vector<std::string> Submission::builtObjects() const
{
    std::vector<std::string> objects;
    for (const auto& [name, part] : m_parts)
        if (part.state == State::Built)
            objects.push_back(objectOf(name));
    return objects;
}

fs::path Submission::featureWorker(const std::string& feature) const
{
    return m_work / m_programs.at(feature);
}

fs::path Submission::wholeWorker() const
{
    return m_work / wholeProgram;
}

}
