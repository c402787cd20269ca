#pragma once
#include "report/sheet.h"

namespace report {

class Studio;

// A figure of the report. Define one at namespace scope to register it; a section's figures stand in the order defined.
class Figure {
public:
    using Draw = Sheet (*)(Studio&);

    // name: section.part, such as texture.bilinear. results: files of other commands, such as bench_error.json, that it
    // shows; without one of them there is no such figure.
    Figure(std::string name, std::string title, Draw draw, std::vector<std::string> results = {});

    std::string name;
    std::string section; // the first part of the name
    std::string title;
    Draw draw; // may throw what Studio throws
    std::vector<std::string> results;

    [[nodiscard]] static const std::vector<Figure>& all();
};

}
