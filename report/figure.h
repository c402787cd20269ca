#pragma once
#include "report/sheet.h"

namespace report {

class Studio;

// Under which of its section's headings a figure stands, drawn or not: rays, numbers and diagrams, or what scenes look
// like. Measurements stand in a section of their own.
enum class Part { VisualDebugging, RenderedImages, Measurements };
NLOHMANN_JSON_SERIALIZE_ENUM(Part,
    { { Part::VisualDebugging, "visual debugging" }, { Part::RenderedImages, "rendered images" },
        { Part::Measurements, "measurements" } })

// A figure of the report. Define one at namespace scope to register it; a section's figures stand in the order defined.
class Figure {
public:
    using Draw = Sheet (*)(Studio&);

    // name: section and one word more, such as texture.bilinear.
    Figure(std::string name, std::string title, Part part, Draw draw);

    // Of measurements. results: files of other commands, such as bench_error.json; without one of them there is no such
    // figure.
    Figure(std::string name, std::string title, Draw draw, std::vector<std::string> results);

    std::string name;
    std::string section; // the first part of the name
    std::string title;
    Part part;
    Draw draw; // may throw what Studio throws
    std::vector<std::string> results;

    [[nodiscard]] static const std::vector<Figure>& all();

private:
    Figure(std::string name, std::string title, Part part, Draw draw, std::vector<std::string> results);
};

}
