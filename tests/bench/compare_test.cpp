#include "../files/temporary_folder.h"
#include "bench/compare.h"
#include "files/error.h"
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace {

using bench::Change;
using bench::Row;

Row row(const std::string& rival, double ratio, double spread = 0.0, const std::string& model = "dragon")
{
    return { model, "primary", rival, 10.0, ratio, ratio - spread, ratio + spread, 0.1, 64.0, 0 };
}

// Of the fastest of ours over the only Embree.
std::vector<Row> rowsOf(double ratio, double spread)
{
    return { row("x86-64-v4", 1.0), row("Embree default", ratio, spread) };
}

Change changeFrom(double then, double thenSpread, double now, double nowSpread)
{
    const std::vector<Change> changes = bench::compare(rowsOf(then, thenSpread), rowsOf(now, nowSpread));
    REQUIRE(changes.size() == 1);
    return changes[0];
}

std::string complaintAbout(const std::string& text)
{
    const files_test::TemporaryFolder folder;
    const std::filesystem::path file = folder.write("then.json", text);
    try {
        (void)bench::readRows(file);
    } catch (const files::Error& error) {
        const std::string complaint = error.what(), start = file.string() + ":";
        REQUIRE(complaint.starts_with(start));
        return complaint.substr(start.size());
    }
    FAIL("read: " << text);
    return {};
}

}

TEST_CASE("What is read of a report is what was written", "[bench]")
{
    const std::vector<Row> rows { { "dragon", "shadow", "Embree high", 12.5, 1.5, 1.25, 1.75, 0.5, 64.0, 3 } };
    const std::vector<Row> read = bench::fromJson(bench::toJson(rows));
    REQUIRE(read.size() == 1);
    CHECK(bench::toJson(read) == bench::toJson(rows));
    CHECK(read[0].rays == "shadow");
    CHECK(read[0].leastRatio == 1.25);
    CHECK(read[0].numDisagreeing == 3);
}

TEST_CASE("Each of our traversals is compared to the better Embree of its own run", "[bench]")
{
    const std::vector<Row> then { row("x86-64-v4", 1.0), row("x86-64-v3", 1.25), row("Embree default", 2.5),
        row("Embree high", 2.0), row("Embree robust", 1.5), row("binary", 9.0) };
    const std::vector<Row> now { row("x86-64-v3", 1.0), row("Embree default", 1.5), row("Embree high", 3.0),
        row("x86-64-v2", 2.0) };
    const std::vector<Change> changes = bench::compare(then, now);
    REQUIRE(changes.size() == 1); // neither another's rows nor what one run alone has
    CHECK(changes[0].rival == "x86-64-v3");
    CHECK(changes[0].then.ratio == Approx(2.0 / 1.25));
    CHECK(changes[0].now.ratio == Approx(1.5));
}

TEST_CASE("Only the same rays of the same model are compared", "[bench]")
{
    const std::vector<Row> teapot { row("x86-64-v4", 1.0, 0.0, "teapot"), row("Embree high", 2.0, 0.0, "teapot") };
    CHECK(bench::compare(teapot, rowsOf(2.0, 0.1)).empty());
    std::vector<Row> diffuse = rowsOf(2.0, 0.1);
    for (Row& row : diffuse)
        row.rays = "diffuse";
    CHECK(bench::compare(diffuse, rowsOf(2.0, 0.1)).empty());
    CHECK(bench::compare({ row("x86-64-v4", 1.0) }, rowsOf(2.0, 0.1)).empty()); // measured without Embree
}

TEST_CASE("The spread of a lead is that of both rates", "[bench]")
{
    const std::vector<Row> rows { row("x86-64-v3", 1.0, 0.25), row("Embree high", 2.0, 0.5) };
    const std::vector<Change> changes = bench::compare(rows, rows);
    REQUIRE(changes.size() == 1);
    CHECK(changes[0].now.least == Approx(1.5 / 1.25));
    CHECK(changes[0].now.most == Approx(2.5 / 0.75));
}

TEST_CASE("Slower is what lost more than the spread of both runs and the tolerance", "[bench]")
{
    CHECK(bench::isRegression(changeFrom(2.0, 0.05, 1.8, 0.05), 0.05));
    CHECK_FALSE(bench::isRegression(changeFrom(2.0, 0.05, 1.8, 0.05), 0.15)); // within the tolerance
    CHECK_FALSE(bench::isRegression(changeFrom(2.0, 0.25, 1.8, 0.01), 0.05)); // within the spread then
    CHECK_FALSE(bench::isRegression(changeFrom(2.0, 0.01, 1.8, 0.25), 0.05)); // within the spread now
    CHECK_FALSE(bench::isRegression(changeFrom(1.8, 0.05, 2.0, 0.05), 0.05)); // faster
    CHECK(changeFrom(2.0, 0.0, 1.5, 0.0).relative() == Approx(-0.25));
}

TEST_CASE("A ratio outside of its repetitions' spread widens it", "[bench]")
{
    std::vector<Row> rows = rowsOf(2.0, 0.0);
    rows[1].leastRatio = 2.1;
    rows[1].mostRatio = 2.2;
    const bench::Lead lead = bench::compare(rows, rows).at(0).now;
    CHECK(lead.least == 2.0);
    CHECK(lead.most == Approx(2.2));
}

TEST_CASE("A file that is no report is told in a line, with what was found and what was expected", "[bench]")
{
    const std::string expected = ", expected what bench traversal --json writes";
    CHECK(complaintAbout("{\n\"rows\": [,]}") == "2: found no JSON" + expected);
    CHECK(complaintAbout("") == "1: found no JSON" + expected);
    CHECK(complaintAbout("[]") == " found JSON without rows" + expected);
    CHECK(complaintAbout(R"({"rows": 3})") == " found rows that are no array" + expected);
    CHECK(complaintAbout(R"({"rows": [3]})") == " found a row whose model is missing" + expected);
    nlohmann::json report { { "rows", bench::toJson(rowsOf(2.0, 0.1)) } };
    report["rows"][1]["ratio"] = "fast";
    CHECK(complaintAbout(report.dump()) == " found a row whose ratio is a string, not a number" + expected);
    CHECK_THROWS_AS(bench::readRows("no such file"), files::Error);
}
