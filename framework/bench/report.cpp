#include "bench/report.h"
#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <map>
#include <nlohmann/json.hpp>

namespace bench {
namespace {

    // By kind of rays, the logarithms of a model's ratios to the fastest of these rivals.
    using Logarithms = std::map<std::string, std::map<std::string, double>>;

    nlohmann::json meansAgainst(const std::vector<Row>& rows, std::span<const std::string_view> rivals)
    {
        Logarithms least;
        for (const Row& row : rows) {
            if (std::ranges::find(rivals, row.rival) == rivals.end())
                continue;
            const auto [place, isNew] = least[row.rays].emplace(row.model, std::log(row.ratio));
            place->second = std::min(place->second, std::log(row.ratio));
        }
        nlohmann::json means = nlohmann::json::object();
        for (const auto& [rays, models] : least) {
            double sum = 0.0;
            for (const auto& [model, logarithm] : models)
                sum += logarithm;
            means[rays] = std::exp(sum / static_cast<double>(models.size()));
        }
        return means;
    }

    template <typename Value> Value valueOf(const nlohmann::json& row, const char* name)
    {
        constexpr bool isText = std::is_same_v<Value, std::string>;
        const auto place = row.find(name); // the end if it is no object
        if (place == row.end())
            throw std::invalid_argument(fmt::format("found a row whose {} is missing", name));
        if (!(isText ? place->is_string() : place->is_number()))
            throw std::invalid_argument(fmt::format(
                "found a row whose {} is a {}, not a {}", name, place->type_name(), isText ? "string" : "number"));
        return place->get<Value>();
    }

}

std::vector<Row> makeRows(const Model& model, const RaySet& set, const Rivals& rivals, const std::vector<Time>& times)
{
    std::vector<Row> rows;
    for (std::size_t i = 0; i < rivals.size(); ++i) {
        Row row { .model = model.name, .rays = std::string(set.name), .rival = rivals[i]->name };
        row.megaraysPerSecond = static_cast<double>(set.rays.size()) * 1e-6 / times[i].seconds;
        row.ratio = times[i].seconds / times[0].seconds;
        std::vector<double> ratios;
        for (std::size_t r = 0; r < times[i].repetitions.size(); ++r)
            ratios.push_back(times[i].repetitions[r] / times[0].repetitions[r]);
        const auto [least, most] = std::ranges::minmax(ratios);
        row.leastRatio = least;
        row.mostRatio = most;
        row.buildSeconds = rivals[i]->buildSeconds;
        row.bytesPerTriangle = static_cast<double>(rivals[i]->numBytes) / static_cast<double>(model.triangles.size());
        row.numDisagreeing = times[i].numDisagreeing;
        rows.push_back(row);
    }
    return rows;
}

nlohmann::json geometricMeans(const std::vector<Row>& rows)
{
    constexpr std::string_view robust[] = { "Embree robust" }, binary[] = { "binary" }, naive[] = { "naive" };
    return { { "embree_best", meansAgainst(rows, bestOfEmbree) }, { "embree_robust", meansAgainst(rows, robust) },
        { "binary", meansAgainst(rows, binary) }, { "naive", meansAgainst(rows, naive) } };
}

nlohmann::json toJson(const std::vector<Row>& rows)
{
    nlohmann::json result = nlohmann::json::array();
    for (const Row& row : rows)
        result.push_back({ { "model", row.model }, { "rays", row.rays }, { "rival", row.rival },
            { "mrays_per_second", row.megaraysPerSecond }, { "ratio", row.ratio }, { "least_ratio", row.leastRatio },
            { "most_ratio", row.mostRatio }, { "build_seconds", row.buildSeconds },
            { "bytes_per_triangle", row.bytesPerTriangle }, { "disagreeing", row.numDisagreeing } });
    return result;
}

std::vector<Row> fromJson(const nlohmann::json& rows)
{
    if (!rows.is_array())
        throw std::invalid_argument("found rows that are no array");
    std::vector<Row> result;
    for (const nlohmann::json& row : rows)
        result.push_back({ valueOf<std::string>(row, "model"), valueOf<std::string>(row, "rays"),
            valueOf<std::string>(row, "rival"), valueOf<double>(row, "mrays_per_second"), valueOf<double>(row, "ratio"),
            valueOf<double>(row, "least_ratio"), valueOf<double>(row, "most_ratio"),
            valueOf<double>(row, "build_seconds"), valueOf<double>(row, "bytes_per_triangle"),
            valueOf<std::size_t>(row, "disagreeing") });
    return result;
}

void print(const Row& row)
{
    fmt::print("{:<20} {:<8} {:<15} {:>7.2f}  {:>5.2f} ({:.2f} to {:.2f})  {:>7.3f} {:>6.0f} {:>9}\n", row.model,
        row.rays, row.rival, row.megaraysPerSecond, row.ratio, row.leastRatio, row.mostRatio, row.buildSeconds,
        row.bytesPerTriangle, row.numDisagreeing);
}

}
