#include "report/pdf.h"
#include "report/program.h"
#include <cstdlib>
#include <stdexcept>

namespace report {
namespace {

    namespace fs = std::filesystem;

    // A profile that is gone with this: Chromium refuses to share one.
    class Profile {
    public:
        Profile()
        {
            std::string name = fs::temp_directory_path() / "raywork-report-XXXXXX";
            if (!mkdtemp(name.data()))
                throw std::runtime_error("no temporary folder for Chromium");
            m_path = name;
        }
        ~Profile()
        {
            std::error_code ignored;
            fs::remove_all(m_path, ignored);
        }
        Profile(const Profile&) = delete;
        Profile& operator=(const Profile&) = delete;

        [[nodiscard]] const fs::path& path() const { return m_path; }

    private:
        fs::path m_path;
    };

}

// Chromium's own sandbox wants namespaces or a set-uid helper, which containers have not; the page may load nothing.
void printPdf(const fs::path& page, const fs::path& pdf)
{
    const Profile profile;
    runProgram({ "chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
        "--disable-background-networking", "--disable-component-update", "--disable-sync", "--no-pdf-header-footer",
        "--generate-pdf-document-outline", "--user-data-dir=" + profile.path().string(),
        "--print-to-pdf=" + fs::absolute(pdf).string(), "file://" + fs::absolute(page).string() });
    if (!fs::exists(pdf))
        throw ProgramFailed("Chromium printed no " + pdf.string());
}

}
