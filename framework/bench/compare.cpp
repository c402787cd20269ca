#include "bench/compare.h"
#include "files/error.h"
#include "files/text.h"
#include <algorithm>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    template <typename Names> bool isAmong(const Names& names, const std::string& rival)
    {
        return std::ranges::find(names, rival) != std::end(names);
    }

    bool isOnSameRays(const Row& a, const Row& b)
    {
        return a.model == b.model && a.rays == b.rays;
    }

    const Row* findBestOfEmbree(const std::vector<Row>& rows, const Row& ours)
    {
        const Row* best = nullptr;
        for (const Row& row : rows)
            if (isOnSameRays(row, ours) && isAmong(bestOfEmbree, row.rival) && (!best || row.ratio < best->ratio))
                best = &row;
        return best;
    }

    // Both rows tell how the first rival compares to them. The sum of each chunk's shortest time may lie outside of
    // what the repetitions say.
    Lead leadOf(const Row& ours, const Row& embree)
    {
        const double ratio = embree.ratio / ours.ratio;
        return { ratio, std::min(ratio, embree.leastRatio / ours.mostRatio),
            std::max(ratio, embree.mostRatio / ours.leastRatio) };
    }

    std::vector<Row> parseRows(const std::filesystem::path& file, const std::string& text)
    {
        try {
            const nlohmann::json report = nlohmann::json::parse(text);
            if (!report.is_object() || !report.contains("rows"))
                throw std::invalid_argument("found JSON without rows");
            return fromJson(report["rows"]);
        } catch (const nlohmann::json::parse_error& error) {
            const auto read = std::string_view(text).substr(0, error.byte);
            throw files::Error(file, 1 + static_cast<int>(std::ranges::count(read, '\n')),
                "found no JSON, expected what bench traversal --json writes");
        } catch (const std::invalid_argument& other) {
            throw files::Error(file, fmt::format("{}, expected what bench traversal --json writes", other.what()));
        }
    }

}

std::vector<Change> compare(const std::vector<Row>& then, const std::vector<Row>& now)
{
    std::vector<Change> changes;
    for (const Row& row : now) {
        const auto before = std::ranges::find_if(
            then, [&](const Row& other) { return isOnSameRays(row, other) && row.rival == other.rival; });
        if (!isAmong(ourNames, row.rival) || before == then.end())
            continue;
        const Row *const embreeThen = findBestOfEmbree(then, row), *const embreeNow = findBestOfEmbree(now, row);
        if (embreeThen && embreeNow)
            changes.push_back(
                { row.model, row.rays, row.rival, leadOf(*before, *embreeThen), leadOf(row, *embreeNow) });
    }
    return changes;
}

bool isRegression(const Change& change, double tolerance)
{
    return change.now.most < change.then.least && change.relative() < -tolerance;
}

std::vector<Row> readRows(const std::filesystem::path& file)
{
    return parseRows(file, files::readText(file));
}

void print(const std::vector<Change>& changes, double tolerance)
{
    const auto text
        = [](const Lead& lead) { return fmt::format("{:.2f} ({:.2f} to {:.2f})", lead.ratio, lead.least, lead.most); };
    fmt::print("\n{:<20} {:<8} {:<15} {:<22} {:<22} over the better Embree\n", "model", "rays", "ours", "then", "now");
    for (const Change& change : changes)
        fmt::print("{:<20} {:<8} {:<15} {:<22} {:<22} {:>+6.1f} %{}\n", change.model, change.rays, change.rival,
            text(change.then), text(change.now), 100.0 * change.relative(),
            isRegression(change, tolerance) ? "  slower" : "");
}

}
