#include "grading/unfinished_file.h"
#include "files/error.h"
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace grading {

UnfinishedFile::UnfinishedFile(const std::filesystem::path& path)
    : m_path(path)
    , m_name(path.string() + ".XXXXXX")
    , m_file(mkostemp(m_name.data(), 0))
{
    if (m_file < 0
        && (errno == ENOSPC || errno == EDQUOT || errno == EIO || errno == EMFILE)) // not for want of a folder
        fail();
    if (m_file < 0)
        throw files::Error(m_path, std::string("cannot be written: ") + std::strerror(errno));
    fchmod(m_file, 0644); // for others to read
}

UnfinishedFile::~UnfinishedFile()
{
    if (m_file >= 0)
        close(m_file);
    if (!m_name.empty())
        unlink(m_name.c_str());
}

void UnfinishedFile::write(std::string_view text)
{
    while (!text.empty()) {
        const ssize_t written = ::write(m_file, text.data(), text.size());
        if (written < 0 && errno != EINTR)
            fail();
        text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
}

void UnfinishedFile::sync()
{
    if (fsync(m_file) != 0)
        fail();
}

void UnfinishedFile::finish()
{
    if (close(std::exchange(m_file, -1)) != 0 || rename(m_name.c_str(), m_path.c_str()) != 0)
        fail();
    m_name.clear();
}

void UnfinishedFile::fail() const
{
    throw std::system_error(errno, std::generic_category(), m_path.string() + ": cannot be written");
}

}
