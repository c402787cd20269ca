#pragma once
#include "worker/message.h"
#include <filesystem>
#include <optional>
#include <string>

namespace grading {

// A folder of what need not be asked again, by all that it depends on. Without a folder it finds nothing and keeps
// nothing.
class KeptMessages {
public:
    // The folder is made. Of more messages than that, those that were used least lately go.
    KeptMessages(std::filesystem::path folder, std::size_t maxMessages);

    [[nodiscard]] std::optional<worker::Message> find(const std::string& key) const;
    void keep(const std::string& key, const worker::Message& message) const;

private:
    std::filesystem::path m_folder;
};

}
