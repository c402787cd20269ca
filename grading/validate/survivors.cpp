#include "grading/validate/survivors.h"
#include "files/table_reader.h"
#include "submission/features.h"
#include <algorithm>

namespace grading {
namespace {

    Survivor readSurvivor(files::TableReader table)
    {
        Survivor survivor { "", "", "", "", table.line() };
        table.require("file", survivor.file);
        table.require("line_text", survivor.original);
        table.require("mutant_text", survivor.changed);
        table.require("why", survivor.why);
        table.finish();
        if (std::ranges::find(submission::features, survivor.file) == submission::features.end())
            table.failFound(*table.find("file"), "a file of the reference, without .cpp");
        return survivor;
    }

}

std::vector<Survivor> loadSurvivors(const std::filesystem::path& list)
{
    std::vector<Survivor> survivors;
    if (!std::filesystem::exists(list))
        return survivors;
    const files::TomlValue document = files::loadToml(list);
    files::TableReader reader { list, document };
    for (files::TableReader& table : reader.readTables("survivor"))
        survivors.push_back(readSurvivor(table));
    reader.finish();
    return survivors;
}

}
