#pragma once
#include "report/location.h"
#include "report/section.h"
#include "report/studio.h"
#include "report/text.h"
#include <vector>

namespace report {

struct SectionContent {
    const Section& section;
    Text text;
    std::vector<Location> locations;
    std::vector<nlohmann::json> figures; // as figure_file.h describes them
};

struct Content {
    const Subject& subject;
    std::string folder; // of the submission, as it was named
    std::filesystem::path figures; // the folder of the figures' files
    std::vector<SectionContent> sections;
    std::vector<nlohmann::json> measurements; // figures of accuracy and speed
};

// The whole report as one page that needs no other file.
[[nodiscard]] std::string makePage(const Content& content);

}
