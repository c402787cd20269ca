#include "grading/live_reference.h"
#include "grading/sealed_file.h"
#include "grading/worker_limits.h"
#include "submission/prune.h"
#include "worker/process.h"

namespace grading {
namespace {

    namespace fs = std::filesystem;

    // The slowest question takes half a minute; a machine may be slow and busy.
    constexpr std::chrono::minutes patience { 10 };
    constexpr std::size_t maxAnswers = 1000; // of some 150 KB each; a version of the reference has about fifty

}

LiveReference::LiveReference(fs::path worker, fs::path folder)
    : m_worker(std::move(worker))
    , m_folder(std::move(folder))
    , m_version(files::Digest().addFile(m_worker).hex())
{
    fs::create_directories(m_folder);
    submission::prune(m_folder, maxAnswers);
}

worker::Message LiveReference::answer(const std::string& probe, const worker::Message& input)
{
    const fs::path file = m_folder / files::Digest().add(m_version).add(keyOf(probe, input)).hex();
    if (std::optional<worker::Message> kept = readSealed(file)) {
        submission::noteUse(file);
        return std::move(*kept);
    }
    worker::Message answer = ask(probe, input);
    writeSealed(file, answer);
    return answer;
}

worker::Message LiveReference::ask(const std::string& probe, const worker::Message& input) const
{
    try {
        worker::Process process { m_worker, limitsOfWorkers() };
        return std::move(process.ask(probe, input, patience).output);
    } catch (const std::exception& error) {
        throw std::runtime_error("the reference's worker, asked for " + probe + ": " + error.what());
    }
}

}
