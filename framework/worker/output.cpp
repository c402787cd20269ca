#include "worker/output.h"
#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace worker {
namespace {

    std::size_t sizeOf(int file)
    {
        struct stat status { };
        return fstat(file, &status) == 0 ? static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) : 0;
    }

    std::string textOf(int file, std::size_t begin, std::size_t end)
    {
        std::string text(end - begin, '\0');
        const ssize_t got = pread(file, text.data(), text.size(), static_cast<off_t>(begin));
        text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        return text;
    }

}

Output::Output()
    : m_file(memfd_create("output", MFD_CLOEXEC))
{
    if (m_file < 0)
        throw std::system_error(errno, std::generic_category(), "memfd_create");
}

std::string Output::take()
{
    const std::size_t end = sizeOf(m_file);
    if (end <= m_taken)
        return {};
    std::string text = textOf(m_file, std::max(m_taken, end - std::min(end, atOnce)), end);
    m_taken = end;
    if (end > kept) // the file goes on where it ended, with a hole before
        fallocate(m_file, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, 0, static_cast<off_t>(end - kept));
    return text;
}

std::string Output::last(std::size_t count) const
{
    const std::size_t end = sizeOf(m_file);
    return textOf(m_file, end - std::min({ end, count, kept }), end);
}

}
