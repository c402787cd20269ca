#include "grading/live_reference.h"
#include "grading/sealed_file.h"
#include "worker/process.h"
#include <algorithm>
#include <vector>

namespace grading {
namespace {

    namespace fs = std::filesystem;

    // The slowest question takes half a minute; a machine may be slow and busy.
    constexpr std::chrono::minutes patience { 10 };
    constexpr worker::Limits limits { .memoryBytes = std::size_t(4) << 30, .outputBytes = std::size_t(1) << 20 };

    constexpr std::uintmax_t mostBytes = 100'000'000; // about 700 answers; a version of the reference has about 50

    struct Kept {
        fs::file_time_type time;
        std::uintmax_t bytes;
        fs::path file;
    };

    // Newest first. A file that another grader removes meanwhile is none.
    std::vector<Kept> keptIn(const fs::path& folder)
    {
        std::vector<Kept> all;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            std::error_code gone;
            const Kept kept { entry.last_write_time(gone), gone ? 0 : entry.file_size(gone), entry.path() };
            if (!gone)
                all.push_back(kept);
        }
        std::ranges::sort(all, std::ranges::greater(), &Kept::time);
        return all;
    }

    void prune(const fs::path& folder)
    {
        std::uintmax_t total = 0;
        for (const Kept& kept : keptIn(folder)) {
            total += kept.bytes;
            std::error_code ignored;
            if (total > mostBytes)
                fs::remove(kept.file, ignored);
        }
    }

}

LiveReference::LiveReference(fs::path worker, fs::path folder)
    : m_worker(std::move(worker))
    , m_folder(std::move(folder))
    , m_version(hashOfFile(m_worker))
{
    fs::create_directories(m_folder);
    prune(m_folder);
}

worker::Message LiveReference::answer(const std::string& probe, const worker::Message& input)
{
    worker::Message versioned;
    versioned << m_version << keyOf(probe, input);
    const fs::path file = m_folder / toHex(hashOf(versioned.bytes()));
    if (std::optional<worker::Message> kept = readSealed(file))
        return std::move(*kept);
    worker::Message answer = ask(probe, input);
    writeSealed(file, answer);
    return answer;
}

worker::Message LiveReference::ask(const std::string& probe, const worker::Message& input) const
{
    try {
        worker::Process process { m_worker, limits };
        return std::move(process.ask(probe, input, patience).output);
    } catch (const std::exception& error) {
        throw std::runtime_error("the reference's worker, asked for " + probe + ": " + error.what());
    }
}

}
