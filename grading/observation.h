#pragma once
#include <string>
#include <vector>

namespace grading {

// What a feature's file draws while a ray is followed, and what the solution does, in the same words. Without points:
// for the person who grades.
struct Observation {
    std::string feature;
    std::vector<std::string> drawn; // a line a kind of shape at a kind of place
    std::vector<std::string> expected;
};

}
