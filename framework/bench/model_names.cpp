#include "bench/model_names.h"
#include <CLI/CLI.hpp>

namespace bench {

void declareModels(CLI::App& command, ModelNames& names)
{
    command.add_option("meshes", names.meshes, "Meshes (.obj)");
    command.add_option("--scene", names.scenes, "A scene of the folder scenes, bowl or field; repeatable")
        ->allow_extra_args(false); // what follows are meshes
}

std::vector<Model> loadModels(const ModelNames& names)
{
    std::vector<Model> models;
    for (const std::string& mesh : names.meshes)
        models.push_back(loadMesh(mesh));
    for (const std::string& scene : names.scenes)
        models.push_back(loadModel(scene));
    if (models.empty())
        for (const char* scene : { "cornell_box", "monkey", "teapot", "dragon", "bowl", "field" })
            models.push_back(loadModel(scene));
    return models;
}

}
