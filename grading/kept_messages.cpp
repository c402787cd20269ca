#include "grading/kept_messages.h"
#include "grading/sealed_file.h"
#include "submission/prune.h"

namespace grading {

KeptMessages::KeptMessages(std::filesystem::path folder, std::size_t maxMessages)
    : m_folder(std::move(folder))
{
    if (m_folder.empty())
        return;
    std::filesystem::create_directories(m_folder);
    submission::prune(m_folder, maxMessages);
}

std::optional<worker::Message> KeptMessages::find(const std::string& key) const
{
    if (m_folder.empty())
        return {};
    std::optional<worker::Message> message = readSealed(m_folder / key);
    if (message)
        submission::noteUse(m_folder / key);
    return message;
}

void KeptMessages::keep(const std::string& key, const worker::Message& message) const
{
    if (!m_folder.empty())
        writeSealed(m_folder / key, message);
}

}
