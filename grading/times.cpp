#include "grading/times.h"
#include "grading/write_whole.h"
#include <nlohmann/json.hpp>

namespace grading {

void writeTimes(const std::filesystem::path& path, const Times& times)
{
    nlohmann::ordered_json json { { "building", times.building }, { "asking", times.asking },
        { "drawing", times.drawing }, { "files", nlohmann::ordered_json::object() } };
    for (const auto& [name, file] : times.files)
        json["files"][name]
            = { { "compiling", file.compiling }, { "linking", file.linking }, { "asking", file.asking } };
    writeWhole(path, json.dump(2) + "\n");
}

}
