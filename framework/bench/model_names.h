#pragma once
#include "bench/model.h"

namespace CLI {
class App;
}

namespace bench {

// What a command is asked to measure with.
struct ModelNames {
    std::vector<std::string> meshes, scenes;
};

void declareModels(CLI::App& command, ModelNames& names);

// Scenes of our own if none is named. Throws files::Error.
[[nodiscard]] std::vector<Model> loadModels(const ModelNames& names);

}
