#include "report/draw_figure.h"
#include "files/digest.h"
#include "files/text.h"
#include "report/figure_file.h"
#include "report/program.h"
#include "submission/paths.h"
#include "values/stopwatch.h"
#include <algorithm>
#include <fmt/format.h>

namespace report {
namespace {

    using nlohmann::json;
    namespace fs = std::filesystem;

    // Of all that a figure is drawn from.
    std::string keyOf(const Figure& figure, const Subject& subject)
    {
        static const std::string ours = files::Digest()
                                            .addFile("/proc/self/exe")
                                            .addFolder(fs::path(submission::sourceDirectory) / "scenes")
                                            .addFolder(fs::path(submission::sourceDirectory) / "report" / "scenes")
                                            .hex();
        files::Digest digest;
        digest.add(figure.name).add(ours).add(subject.name).addFile(subject.submission).addFile(subject.reference);
        for (const std::string& result : figure.results)
            digest.addFile(findResult(subject, result));
        return digest.hex();
    }

    json knownFigure(const fs::path& file, const std::string& key)
    {
        if (!fs::exists(file))
            return {};
        json known = json::parse(files::readText(file), nullptr, false);
        return known.is_object() && known.value("key", "") == key ? known : json();
    }

    void removeFilesOf(const Figure& figure, const fs::path& folder)
    {
        std::vector<fs::path> old;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            if (entry.path().filename().string().starts_with(figure.name + "."))
                old.push_back(entry.path());
        for (const fs::path& path : old)
            fs::remove(path);
    }

    // Unless the figure tells how long its picture took, how long all took that it asked for.
    void tellSeconds(std::vector<Fact>& facts, double seconds)
    {
        if (std::ranges::find(facts, "seconds", &Fact::name) == facts.end())
            facts.push_back({ "seconds", fmt::format("{:.2f}", seconds) });
    }

    Sheet drawIn(Studio& studio, const Figure& figure)
    {
        const values::Stopwatch watch;
        Sheet sheet = figure.draw(studio);
        if (figure.part != Part::Measurements) // made elsewhere
            tellSeconds(sheet.facts, watch.seconds());
        return sheet;
    }

    json draw(const Figure& figure, const Subject& subject, const fs::path& folder)
    {
        Studio studio { subject, figure.section };
        try {
            json drawn = saveSheet(folder, figure.name, drawIn(studio, figure));
            drawn["state"] = "drawn";
            drawn["stubs"] = studio.stubs();
            return drawn;
        } catch (const NotWritten& stubs) {
            return { { "state", "not written" }, { "message", stubs.what() } };
        } catch (const ProgramFailed&) { // is none of the submission's faults
            throw;
        } catch (const std::exception& error) { // a crash, an endless loop, an answer that is none
            return { { "state", "failed" }, { "message", error.what() } };
        }
    }

}

DrawnFigure drawFigure(const Figure& figure, const Subject& subject, const fs::path& folder)
{
    const fs::path file = folder / (figure.name + ".json");
    const std::string key = keyOf(figure, subject);
    if (json known = knownFigure(file, key); !known.is_null())
        return { std::move(known), false };
    removeFilesOf(figure, folder);
    json drawn = draw(figure, subject, folder);
    drawn["name"] = figure.name;
    drawn["title"] = figure.title;
    drawn["part"] = figure.part;
    drawn["key"] = key;
    files::writeText(file, drawn.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
    return { std::move(drawn) };
}

bool canBeDrawn(const Figure& figure, const Subject& subject)
{
    return std::ranges::all_of(
        figure.results, [&](const std::string& result) { return !findResult(subject, result).empty(); });
}

}
