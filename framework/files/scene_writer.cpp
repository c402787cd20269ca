#include "files/scene_writer.h"
#include "files/error.h"
#include "files/scene_config.h"
#include "files/scene_lights.h"
#include "files/scene_tables.h"
#include "files/text.h"
#include "files/write_readable.h"
#include <algorithm>

namespace files {
namespace {

    namespace fs = std::filesystem;

    // The file that `name` means in the folder `from`, as named in the folder `to`. A link to a file stays one, since
    // what the file names in turn is looked up beside the link.
    std::string renamed(const std::string& name, const fs::path& from, const fs::path& to)
    {
        const fs::path path = name;
        if (path.is_absolute())
            return name;
        const fs::path folder = fs::absolute(from / path).parent_path();
        return (fs::relative(folder, to) / path.filename()).lexically_normal().string();
    }

    void renameFiles(TomlValue& meshes, const fs::path& from, const fs::path& to)
    {
        if (auto* array = std::get_if<TomlValue::Array>(&meshes.content))
            for (TomlValue& mesh : *array)
                renameFiles(mesh, from, to);
        else if (auto* table = std::get_if<TomlValue::Table>(&meshes.content))
            for (TomlEntry& entry : *table)
                if (auto* name = std::get_if<std::string>(&entry.value.content);
                    name != nullptr && (entry.key == "file" || entry.key == "texture"))
                    *name = renamed(*name, from, to);
    }

    // The original as a scene file; a model is one of that mesh alone.
    TomlValue::Table loadOriginal(const fs::path& path)
    {
        if (lowerExtension(path) == ".toml")
            return std::get<TomlValue::Table>(loadToml(path).content);
        const TomlValue::Table mesh { { "file", { .content = path.filename().string() } } };
        return { { "mesh", { .content = TomlValue::Array { { .content = mesh } } } } };
    }

    TomlValue::Table sceneTable(const fs::path& to, const fs::path& original, const Config& config,
        const std::vector<Scene::SceneLight>& lights)
    {
        TomlValue::Table scene = configTables(config);
        bool hasFrame = false;
        for (TomlEntry& entry : loadOriginal(original)) {
            if (entry.key == "light" || std::ranges::find(scene, entry.key, &TomlEntry::key) != scene.end())
                continue;
            if (entry.key == "mesh")
                renameFiles(entry.value, original.parent_path(), fs::absolute(to).parent_path());
            hasFrame = hasFrame || entry.key == "frame";
            scene.push_back(std::move(entry));
        }
        if (!lights.empty())
            scene.push_back(lightTables(lights, hasFrame));
        return scene;
    }

    // What is new in it.
    void readAgain(const fs::path& path, const TomlValue& document)
    {
        TableReader top(path, document);
        (void)readConfig(top);
        for (TableReader& table : top.readTables("light"))
            (void)readLight(table, {});
    }

}

void saveScene(
    const fs::path& to, const fs::path& original, const Config& config, const std::vector<Scene::SceneLight>& lights)
{
    if (lowerExtension(to) != ".toml")
        throw Error(to, "found the extension \"" + to.extension().string() + "\", expected a scene in .toml");
    try {
        writeReadable(
            to, sceneTable(to, original, config, lights), [&](const TomlValue& document) { readAgain(to, document); });
    } catch (const fs::filesystem_error& error) {
        throw Error(to, "cannot be written: " + error.code().message());
    }
}

}
