#include "submission/folder_lock.h"
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace submission {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : m_file(open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644))
{
    int result = -1;
    while (m_file >= 0 && (result = flock(m_file, LOCK_EX)) != 0 && errno == EINTR) { }
    if (result != 0)
        throw std::system_error(errno, std::generic_category(), (folder / "lock").string());
}

FolderLock::~FolderLock()
{
    close(m_file);
}

}
