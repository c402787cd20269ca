#include "submission/ninja.h"
#include "files/text.h"
#include "submission/paths.h"
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <stdexcept>

namespace submission {
namespace {

    std::string readIfThere(const std::filesystem::path& path)
    {
        return std::filesystem::exists(path) ? files::readText(path) : "";
    }

}

Ninja::Ninja(std::filesystem::path folder)
    : m_folder(std::move(folder))
    , m_edges(fmt::format("include {}/rules.ninja\n", buildDirectory))
{
}

void Ninja::addCompile(const std::string& object, const std::string& source)
{
    m_edges += fmt::format("build {}: compile {}\n", object, source);
}

void Ninja::addLink(const std::string& program, const std::vector<std::string>& inputs, const std::string& variable)
{
    m_edges += fmt::format("build {}: link {} | archives\n  rest = ${}\n", program, fmt::join(inputs, " "), variable);
}

void Ninja::build(const std::vector<std::string>& outputs)
{
    std::ofstream(m_folder / "build.ninja") << m_edges;
    const std::string command = fmt::format("'{}' -C '{}' -k 0 {} > '{}' 2>&1", ninjaProgram, m_folder.string(),
        fmt::join(outputs, " "), (m_folder / "ninja.log").string());
    (void)std::system(command.c_str()); // what does not compile shows in the outputs that are missing
    const std::string said = readIfThere(m_folder / "ninja.log");
    if (const std::size_t fatal = std::min(said.find("ninja: fatal"), said.find("ninja: error")); fatal < said.size())
        throw std::runtime_error(said.substr(fatal));
}

bool Ninja::succeeded(const std::string& output) const
{
    return std::filesystem::exists(m_folder / output);
}

std::string Ninja::dependencies(const std::string& object) const
{
    return readIfThere(m_folder / (object + ".d"));
}

std::string Ninja::log(const std::string& output) const
{
    return readIfThere(m_folder / (output + ".log"));
}

}
