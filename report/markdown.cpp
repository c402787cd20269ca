#include "report/markdown.h"
#include "files/digest.h"
#include "files/text.h"
#include "report/html.h"
#include "report/program.h"
#include "submission/cache.h"
#include <regex>

namespace report {
namespace {

    namespace fs = std::filesystem;

    // Headings of a text are below those of the page, so that the first level becomes the third.
    bool turn(const std::string& markdown, const fs::path& folder)
    {
        files::writeText(folder / "text.md", markdown);
        runProgram({ "pandoc", "--from", "markdown-raw_html-raw_tex", "--to", "html5", "--wrap=none", "--mathml",
            "--shift-heading-level-by=1", "--id-prefix=text-", "-o", (folder / "text.html").string(),
            (folder / "text.md").string() });
        return true;
    }

    bool liesIn(const fs::path& folder, const fs::path& path)
    {
        const fs::path relative = fs::weakly_canonical(path).lexically_relative(fs::weakly_canonical(folder));
        return !relative.empty() && *relative.begin() != ".." && fs::is_regular_file(path);
    }

    std::string addressOf(const std::string& name, const fs::path& folder)
    {
        const fs::path path = folder / name;
        const std::string extension = files::lowerExtension(path);
        const bool isPicture
            = extension == ".png" || extension == ".jpg" || extension == ".jpeg" || extension == ".svg";
        return isPicture && liesIn(folder, path) ? dataUri(path) : "data:,";
    }

    std::string withPictures(const std::string& html, const fs::path& folder)
    {
        static const std::regex source(R"~(\ssrc="([^"]*)")~"); // of pictures, and of what Pandoc takes for a film
        std::string filled;
        auto rest = html.begin();
        for (std::sregex_iterator found(html.begin(), html.end(), source), end; found != end; ++found) {
            filled.append(rest, html.begin() + found->position());
            filled += " src=\"" + addressOf((*found)[1], folder) + "\"";
            rest = html.begin() + found->position() + found->length();
        }
        return filled.append(rest, html.end());
    }

}

std::string toHtml(const std::string& markdown, const fs::path& folder)
{
    const std::string key = files::Digest().add("pandoc --wrap=none").add(markdown).hex();
    const fs::path kept = submission::cached(key, [&](const fs::path& made) { return turn(markdown, made); });
    return withPictures(files::readText(kept / "text.html"), folder);
}

}
