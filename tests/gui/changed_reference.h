#pragma once
#include "../files/temporary_folder.h"
#include "submission/paths.h"

namespace tests {

inline const std::filesystem::path source { submission::sourceDirectory };
inline const std::filesystem::path reference = source / "reference";
inline const std::filesystem::path cornell = source / "scenes" / "cornell_box.toml";

// The reference with one file that says something else.
class ChangedReference {
public:
    ChangedReference(const std::string& name, const std::string& text)
    {
        std::filesystem::copy(reference, m_folder / "", std::filesystem::copy_options::recursive);
        m_file = m_folder.write(name, text);
    }

    [[nodiscard]] std::filesystem::path path() const { return m_folder / ""; }

    // As the reference has it.
    void repair() const
    {
        std::filesystem::copy_file(
            reference / m_file.filename(), m_file, std::filesystem::copy_options::overwrite_existing);
    }

private:
    files_test::TemporaryFolder m_folder;
    std::filesystem::path m_file;
};

}
