// ./raywork bench: measures the library against others.
#include "app/run_command.h"
#include "bench/render.h"
#include "bench/report.h"
#include "bench/watertight.h"
#include "files/error.h"
#include <fstream>
#include <nlohmann/json.hpp>

namespace {

struct Options {
    std::vector<std::string> meshes, scenes;
    std::string json;
    std::size_t numRays = 1 << 17;
    std::size_t numLeakRays = 20'000'000;
    int numRepetitions = 5;
    bool onlyFast = false;
};

void declare(CLI::App& cli, Options& options)
{
    cli.require_subcommand(1);
    CLI::App& watertight
        = *cli.add_subcommand("watertight", "Rays at corners and edges of closed meshes: how many slip through");
    watertight.add_option("--rays", options.numLeakRays, "Rays")->capture_default_str()->check(CLI::PositiveNumber);
    CLI::App& traversal = *cli.add_subcommand("traversal", "One ray after the other through a tree, on one thread");
    traversal.add_option("meshes", options.meshes, "Meshes (.obj)");
    traversal.add_option("--scene", options.scenes, "A scene of the folder scenes, bowl or field; repeatable")
        ->allow_extra_args(false); // what follows are meshes
    traversal.add_option("--json", options.json, "Write the figures to this file");
    traversal.add_option("--rays", options.numRays, "Rays in a set")->capture_default_str()->check(CLI::PositiveNumber);
    traversal.add_option("--repetitions", options.numRepetitions, "Times that each ray is traced")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    traversal.add_flag("--only-fast", options.onlyFast, "Leave out those that take ten times as long");
}

std::vector<bench::Model> loadModels(const Options& options)
{
    std::vector<bench::Model> models;
    for (const std::string& mesh : options.meshes)
        models.push_back(bench::loadMesh(mesh));
    for (const std::string& scene : options.scenes)
        models.push_back(bench::loadModel(scene));
    if (models.empty())
        for (const char* scene : { "cornell_box", "monkey", "teapot", "dragon", "bowl", "field" })
            models.push_back(bench::loadModel(scene));
    return models;
}

std::vector<bench::Row> measureModel(const bench::Model& model, const Options& options)
{
    bench::Rivals rivals;
    bench::addWide(model.triangles, rivals);
    bench::addEmbree(model.triangles, rivals);
    if (!options.onlyFast)
        bench::addBinary(model.triangles, rivals);

    std::vector<bench::Row> rows;
    const accel::WideTree tree(model.triangles);
    for (const bench::RaySet& set : bench::makeRaySets(model, tree, options.numRays))
        for (const bench::Row& row :
            bench::makeRows(model, set, rivals, measure(set, rivals, options.numRepetitions))) {
            bench::print(row);
            rows.push_back(row);
        }
    return rows;
}

void measureTraversal(const Options& options)
{
    fmt::print("{:<20} {:<8} {:<15} {:>7}  ours over it            build s  B/tri  disagree\n", "model", "rays",
        "rival", "M/s");
    std::vector<bench::Row> rows;
    for (const bench::Model& model : loadModels(options)) {
        const std::vector<bench::Row> more = measureModel(model, options);
        rows.insert(rows.end(), more.begin(), more.end());
    }
    const nlohmann::json report { { "rows", bench::toJson(rows) }, { "geomean", bench::geometricMeans(rows) } };
    fmt::print("{}\n", report["geomean"].dump());
    if (!options.json.empty() && !(std::ofstream(options.json) << report.dump(2) << '\n'))
        throw files::Error(options.json, "cannot be written");
}

}

int main(int argc, char** argv)
{
    CLI::App cli { "Measures the library against others.", "./raywork bench" };
    Options options;
    declare(cli, options);
    bench::RenderOptions renderOptions;
    bench::declareRender(cli, renderOptions);
    return app::runCommand(cli, argc, argv, [&]() -> int {
        if (cli.got_subcommand("render"))
            return bench::measureRender(renderOptions);
        if (cli.got_subcommand("watertight"))
            bench::measureLeaks(options.numLeakRays);
        else
            measureTraversal(options);
        return app::Success;
    });
}
