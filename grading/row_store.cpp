#include "grading/row_store.h"
#include "worker/message.h"

namespace grading {
namespace {

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

RowStore::RowStore(std::filesystem::path folder)
    : m_messages(std::move(folder), maxRows)
{
}

std::optional<Row> RowStore::find(const std::string& key) const
{
    const std::optional<worker::Message> message = m_messages.find(key);
    return message ? std::optional(toRow(*message)) : std::nullopt;
}

void RowStore::keep(const std::string& key, const Row& row) const
{
    if (row.status != Status::Crashed && row.status != Status::TimedOut)
        m_messages.keep(key, toMessage(row));
}

}
