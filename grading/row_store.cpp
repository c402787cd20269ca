#include "grading/row_store.h"
#include "grading/sealed_file.h"
#include "submission/prune.h"
#include "worker/message.h"

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

}

RowStore::RowStore(fs::path folder)
    : m_folder(std::move(folder))
{
    if (m_folder.empty())
        return;
    fs::create_directories(m_folder);
    submission::prune(m_folder, maxRows);
}

std::optional<Row> RowStore::find(const std::string& key) const
{
    const fs::path path = m_folder / key;
    const std::optional<worker::Message> message = m_folder.empty() ? std::nullopt : readSealed(path);
    if (!message)
        return {};
    submission::noteUse(path);
    return toRow(*message);
}

void RowStore::keep(const std::string& key, const Row& row) const
{
    if (!m_folder.empty() && row.status != Status::Crashed && row.status != Status::TimedOut)
        writeSealed(m_folder / key, toMessage(row));
}

}
