#pragma once
#include <filesystem>

namespace submission {

// Keeps other processes out of a folder while it lives; waits for one that is in.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int m_file;
};

}
