#pragma once
#include "debug/strokes.h"
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

namespace report {

// Labels are a few words that stand under what they name.

struct Picture {
    std::string label;
    glm::ivec2 size { 0 };
    std::vector<glm::vec3> pixels; // row 0 at the bottom
};

// Lines and areas over a picture.
struct Drawing {
    Picture picture;
    std::vector<debug::Stroke> strokes;
};

// What gnuplot makes of a script: see plot.h.
struct Plot {
    std::string label;
    std::string script;
    glm::ivec2 size { 640, 400 }; // CSS pixels
};

// Two pictures of one size, the second over the first, with a line between them that a reader moves.
struct Slider {
    Picture before, after;
};

struct Table {
    std::string label;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows; // as long as the head
};

using Panel = std::variant<Picture, Drawing, Plot, Slider, Table>;

// Of how it was made, for the caption: "samples", "16".
struct Fact {
    std::string name, value;
};

// What the figure is to show, with the numbers that show it.
struct Claim {
    std::string text;
    bool holds = false;
};

// What a figure consists of.
struct Sheet {
    std::vector<Panel> panels; // in reading order
    int columns = 2; // on a page of paper
    std::vector<Fact> facts;
    std::vector<Claim> claims;
    nlohmann::json data; // numbers behind the figure, for tests and for who wants to draw it otherwise
};

}
