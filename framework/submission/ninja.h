#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace submission {

// A folder with a build.ninja in which submissions' files are compiled and linked by the rules that CMake wrote.
class Ninja {
public:
    explicit Ninja(std::filesystem::path folder);

    void addCompile(const std::string& object, const std::string& source);
    // inputs: objects of the folder; variable: the rest of the link, a variable of the rules.
    void addLink(const std::string& program, const std::vector<std::string>& inputs, const std::string& variable);

    // Brings the outputs up to date, as many as can be; succeeded() tells which.
    void build(const std::vector<std::string>& outputs);
    [[nodiscard]] bool succeeded(const std::string& output) const;
    // What an object was compiled from, as make reads it.
    [[nodiscard]] std::string dependencies(const std::string& object) const;
    // What the compiler or linker printed.
    [[nodiscard]] std::string log(const std::string& output) const;

private:
    std::filesystem::path m_folder;
    std::string m_edges;
};

}
