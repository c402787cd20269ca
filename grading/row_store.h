#pragma once
#include "grading/kept_messages.h"
#include "grading/row.h"
#include <filesystem>
#include <optional>
#include <string>

namespace grading {

// Rows of earlier gradings, by all that they depend on: a check is not repeated while nothing that it can see changed.
class RowStore {
public:
    // Without a folder it finds nothing and keeps nothing.
    explicit RowStore(std::filesystem::path folder);

    [[nodiscard]] std::optional<Row> find(const std::string& key) const;
    // Crashes and time-outs are not kept: they may have come of a machine that was busy.
    void keep(const std::string& key, const Row& row) const;

private:
    KeptMessages m_messages;
};

}
