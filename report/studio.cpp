#include "report/studio.h"
#include "files/error.h"
#include "files/text.h"
#include "report/section.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace report {
namespace {

    // The slowest request takes the reference two seconds; a machine may be busy.
    constexpr std::chrono::seconds patience { 20 };

    worker::Limits limits()
    {
        worker::Limits limits;
        limits.memoryBytes = std::size_t(8) << 30;
        limits.answerBytes = std::size_t(1) << 30;
        limits.cpuTime = 4 * patience;
        limits.readable = { "/" };
        return limits;
    }

}

NotWritten::NotWritten(const std::vector<std::string>& functions)
    : std::runtime_error(fmt::format("{}", fmt::join(functions, ", ")))
{
}

std::filesystem::path findResult(const Subject& subject, const std::string& file)
{
    for (const std::filesystem::path& folder : subject.results)
        if (std::filesystem::exists(folder / file))
            return folder / file;
    return {};
}

Studio::Studio(const Subject& subject, std::string section)
    : m_subject(subject)
    , m_section(std::move(section))
{
}

worker::Rendering Studio::render(Who who, const worker::RenderRequest& request)
{
    return ask<worker::Rendering>(who, "render.image", request);
}

worker::DebugRay Studio::followRay(Who who, const worker::RenderRequest& request, glm::ivec2 pixel)
{
    return ask<worker::DebugRay>(who, "debug.ray", worker::DebugRayRequest { request, pixel });
}

std::string Studio::nameOf(Who who) const
{
    return who == Who::Submission ? m_subject.name : "reference";
}

nlohmann::json Studio::result(const std::string& file) const
{
    const std::filesystem::path path = findResult(m_subject, file);
    try {
        return nlohmann::json::parse(files::readText(path));
    } catch (const nlohmann::json::exception& error) {
        throw files::Error(path, std::string("cannot be read as JSON: ") + error.what());
    }
}

worker::Message Studio::run(Who who, const std::string& probe, const worker::Message& message)
{
    std::unique_ptr<worker::Process>& process = m_processes[who == Who::Reference];
    if (!process)
        process = std::make_unique<worker::Process>(
            who == Who::Reference ? m_subject.reference : m_subject.submission, limits());
    worker::Answer answer = process->ask(probe, message, patience);
    note(answer.unwritten);
    return std::move(answer.output);
}

// A stub of the figure's own section leaves nothing to show.
void Studio::note(const std::vector<std::string>& unwritten)
{
    const std::vector<std::string> own = functionsOf(m_section);
    std::vector<std::string> missing;
    for (const std::string& function : unwritten)
        if (std::ranges::find(own, function) != own.end())
            missing.push_back(function);
        else if (std::ranges::find(m_stubs, function) == m_stubs.end())
            m_stubs.push_back(function);
    if (!missing.empty())
        throw NotWritten(missing);
}

}
