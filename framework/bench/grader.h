#pragma once
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

namespace bench {

// What a grading took, in seconds.
struct GradeTimes {
    struct OfFile {
        double compiling, linking, asking;
    };

    double total; // of the program, from its start to its end
    double building, asking, drawing; // as the program tells
    std::map<std::string, OfFile> files; // side by side

    [[nodiscard]] double rest() const { return total - building - asking - drawing; } // starting, reporting
};

class GraderFailed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The grader as its user starts it, with a copy of a submission and with a cache of its own, both in a folder that is
// gone with this.
class Grader {
public:
    // Throws files::Error if the submission is no folder.
    explicit Grader(const std::filesystem::path& submission);
    ~Grader();
    Grader(const Grader&) = delete;
    Grader& operator=(const Grader&) = delete;

    // Throws GraderFailed.
    [[nodiscard]] GradeTimes grade() const;

    void forgetAll() const;
    // So that the file was never seen. A comment: it compiles to the same.
    void change(const std::string& name);

private:
    std::filesystem::path m_folder;
    int m_numChanges = 0;
};

}
