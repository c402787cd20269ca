#include "report/made.h"
#include "files/text.h"
#include <array>
#include <catch2/catch.hpp>
#include <iterator>
#include <sstream>

namespace report_test {

namespace fs = std::filesystem;

fs::path madeReport(const std::string& submission)
{
    return fs::path(RAYWORK_REPORTS) / submission / "report";
}

nlohmann::json figure(const std::string& name, const std::string& submission)
{
    return nlohmann::json::parse(files::readText(madeReport(submission) / "figures" / (name + ".json")));
}

void checkClaims(const nlohmann::json& figure)
{
    CHECK(!figure.at("claims").empty());
    for (const nlohmann::json& claim : figure.at("claims")) {
        INFO(claim.at("text"));
        CHECK(claim.at("holds") == true);
    }
}

std::vector<nlohmann::json> figures(const std::string& submission)
{
    std::vector<nlohmann::json> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(madeReport(submission) / "figures"))
        if (entry.path().extension() == ".json")
            all.push_back(nlohmann::json::parse(files::readText(entry.path())));
    return all;
}

std::string scriptOf(const std::string& figure, int panel)
{
    return files::readText(madeReport("reference") / "figures" / (figure + "." + std::to_string(panel) + ".gnuplot"));
}

std::vector<std::vector<double>> plottedRows(const std::string& figure, int panel, const std::string& block)
{
    std::istringstream script(scriptOf(figure, panel));
    std::string line;
    while (std::getline(script, line) && line != "$" + block + " << EOD") { }
    std::vector<std::vector<double>> rows;
    while (std::getline(script, line) && line != "EOD") {
        std::istringstream numbers(line);
        rows.emplace_back(std::istream_iterator<double>(numbers), std::istream_iterator<double>());
    }
    return rows;
}

std::string run(const std::string& command)
{
    INFO(command);
    FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string printed;
    std::array<char, 4096> buffer {};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        printed.append(buffer.data(), count);
    INFO(printed);
    REQUIRE(pclose(pipe) == 0);
    return printed;
}

}
