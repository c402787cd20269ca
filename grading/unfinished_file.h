#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace grading {

// A file that appears whole or not at all, so that whoever reads it beside us sees the old one or the new one: it has a
// name that no other process has until it is finished, and is gone if it never is.
class UnfinishedFile {
public:
    // Throws files::Error if nothing can be created there.
    explicit UnfinishedFile(const std::filesystem::path& path);
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    // The others throw std::system_error, as on a full disk.
    void write(std::string_view text);
    // Some disks say only now that they are full.
    void sync();
    void finish();

private:
    [[noreturn]] void fail() const;

    std::filesystem::path m_path;
    std::string m_name;
    int m_file;
};

}
