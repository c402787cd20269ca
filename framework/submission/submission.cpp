#include "submission/submission.h"
#include <stdexcept>
#include <tbb/parallel_for_each.h>

namespace submission {

Submission::Submission(const std::filesystem::path& directory)
    : m_sources(readSources(directory))
{
    for (const auto& [name, source] : m_sources)
        m_objects[name];
}

std::vector<std::string> Submission::names() const
{
    std::vector<std::string> names;
    for (const auto& [name, source] : m_sources)
        names.push_back(name);
    return names;
}

void Submission::buildFeatureWorkers(const std::vector<std::string>& wanted)
{
    for (const std::string& feature : wanted)
        m_workers[feature];
    tbb::parallel_for_each(wanted, [&](const std::string& feature) {
        if (whyUntouched(feature).empty())
            buildFeatureWorker(feature);
    });

    // A file may use functions of the submission's other files. Then it is tried together with all of them.
    for (const std::string& feature : wanted) {
        Program& worker = m_workers.at(feature);
        if (worker.errors.empty())
            continue;
        compileAll();
        const std::string errorsAlone = worker.errors;
        worker = link(builtObjects(), "questioned");
        if (!worker.errors.empty())
            m_sources.at(feature).part = refused(errorsAlone);
    }
}

void Submission::buildFeatureWorker(const std::string& feature)
{
    compileOnce(feature);
    if (part(feature).state == State::Built)
        m_workers.at(feature) = link({ m_objects.at(feature) }, feature);
}

std::filesystem::path Submission::buildWholeWorker(const std::string& rest)
{
    compileAll();
    const Program worker = link(builtObjects(), rest);
    if (!worker.errors.empty())
        throw std::runtime_error(worker.errors);
    return worker.file;
}

Program Submission::buildStressedWorker(const std::string& feature)
{
    compileOnce(feature);
    const bool isBuilt = part(feature).state == State::Built;
    const Program alone
        = link(isBuilt ? std::vector { m_objects.at(feature) } : std::vector<Object>(), "stressed_" + feature);
    if (alone.errors.empty())
        return alone;
    compileAll();
    return link(builtObjects(), "stressed");
}

void Submission::compileAll()
{
    tbb::parallel_for_each(names(), [&](const std::string& name) { compileOnce(name); });
}

void Submission::compileOnce(const std::string& name)
{
    Source& source = m_sources.at(name);
    if (source.part.state != State::Taken)
        return;
    Object& object = m_objects.at(name);
    object = compile(name, source.text);
    source.part = object.part;
}

std::vector<Object> Submission::builtObjects() const
{
    std::vector<Object> objects;
    for (const auto& [name, object] : m_objects)
        if (part(name).state == State::Built)
            objects.push_back(object);
    return objects;
}

}
