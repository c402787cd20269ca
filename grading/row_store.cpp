#include "grading/row_store.h"
#include "files/text.h"
#include "submission/paths.h"
#include "submission/prune.h"
#include "worker/message.h"
#include <fstream>
#include <thread>
#include <unistd.h>

namespace grading {
namespace {

    namespace fs = std::filesystem;

    // Of about fifty submissions, of some 3 MB each for the pictures.
    constexpr std::size_t maxRows = 5000;

    worker::Message toMessage(const Row& row)
    {
        worker::Message message;
        message << row.name << row.feature << row.score << row.maxScore << row.status << row.message << row.usualCause
                << bool(row.pictures);
        if (row.pictures)
            message << row.pictures->size << row.pictures->came << row.pictures->expected << row.pictures->worst;
        return message;
    }

    Row toRow(const worker::Message& message)
    {
        worker::Reader reader { message };
        Row row;
        reader >> row.name >> row.feature >> row.score >> row.maxScore >> row.status >> row.message >> row.usualCause;
        if (reader.read<bool>()) {
            PicturePair pictures;
            reader >> pictures.size >> pictures.came >> pictures.expected >> pictures.worst;
            row.pictures = std::make_shared<PicturePair>(std::move(pictures));
        }
        return row;
    }

    worker::Message readMessage(const fs::path& path)
    {
        const std::string text = files::readText(path);
        worker::Message message;
        message.append(text.data(), text.size());
        return message;
    }

}

RowStore::RowStore(bool isWanted)
    : m_isWanted(isWanted)
    , m_folder(fs::path(submission::buildDirectory) / "grading" / "rows")
{
    fs::create_directories(m_folder);
    submission::prune(m_folder, maxRows);
}

std::optional<Row> RowStore::find(const std::string& key) const
{
    const fs::path path = m_folder / key;
    if (!m_isWanted || !fs::exists(path))
        return {};
    try {
        const Row row = toRow(readMessage(path));
        submission::noteUse(path);
        return row;
    } catch (const std::exception&) { // cut short, or gone by now: then the check is repeated
        return {};
    }
}

void RowStore::keep(const std::string& key, const Row& row) const
{
    if (!m_isWanted || row.status == Status::Crashed || row.status == Status::TimedOut)
        return;
    const std::size_t thread = std::hash<std::thread::id> {}(std::this_thread::get_id());
    const fs::path unfinished = m_folder / (key + "." + std::to_string(getpid()) + "." + std::to_string(thread));
    std::ofstream file(unfinished, std::ios::binary);
    const worker::Message message = toMessage(row);
    file.write(reinterpret_cast<const char*>(message.bytes().data()), static_cast<long>(message.bytes().size()));
    file.close();
    std::error_code failed; // a row that is not kept is asked for again
    if (file)
        fs::rename(unfinished, m_folder / key, failed);
    else
        fs::remove(unfinished, failed);
}

}
