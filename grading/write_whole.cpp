#include "grading/write_whole.h"
#include "files/error.h"
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace grading {
namespace {

    namespace fs = std::filesystem;

    // A file under another name until it is complete; gone if it never is.
    class Unfinished {
    public:
        explicit Unfinished(const fs::path& path)
            : m_path(path)
            , m_name(path.string() + ".unfinished")
            , m_file(open(m_name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666))
        {
            if (m_file < 0)
                throw files::Error(m_path, std::string("cannot be written: ") + std::strerror(errno));
        }

        ~Unfinished()
        {
            if (m_file >= 0)
                close(m_file);
            if (!m_finished)
                unlink(m_name.c_str());
        }

        Unfinished(const Unfinished&) = delete;
        Unfinished& operator=(const Unfinished&) = delete;

        void write(std::string_view text)
        {
            while (!text.empty()) {
                const ssize_t written = ::write(m_file, text.data(), text.size());
                if (written < 0 && errno != EINTR)
                    fail();
                text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
            }
        }

        // Some disks say only now that they are full.
        void finish()
        {
            if (fsync(m_file) != 0)
                fail();
            if (close(std::exchange(m_file, -1)) != 0)
                fail();
            if (rename(m_name.c_str(), m_path.c_str()) != 0)
                fail();
            m_finished = true;
        }

    private:
        [[noreturn]] void fail() const
        {
            throw std::system_error(errno, std::generic_category(), m_path.string() + ": cannot be written");
        }

        fs::path m_path;
        std::string m_name;
        int m_file;
        bool m_finished = false;
    };

}

void writeWhole(const fs::path& path, std::string_view text)
{
    Unfinished file { path };
    file.write(text);
    file.finish();
}

}
