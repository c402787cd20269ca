#pragma once
#include <filesystem>
#include <string>

namespace report {

struct Options {
    std::string submission = "student"; // as in submission::namedFolder
    std::filesystem::path output; // empty: <the submission's name>-report
    std::string only; // figure or section; empty: all, and the page
};

// Draws what is new and writes the page and the PDF; tells on stdout what became of each figure. Throws files::Error
// for a folder that is none, and ProgramFailed.
void makeReport(Options options);

}
