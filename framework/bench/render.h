#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bench {

struct RenderOptions {
    std::vector<std::string> scenes; // of the folder scenes; empty: a few
    std::string with = "reference";
    std::string size = "512x512";
    std::string json;
    uint32_t numRepetitions = 5;
};

void declareRender(CLI::App& cli, RenderOptions& options);

// Measures and prints whole frames beside bare traversal. Returns an app::ExitCode; throws on bad input.
[[nodiscard]] int measureRender(const RenderOptions& options);

}
