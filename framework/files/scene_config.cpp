#include "files/scene_config.h"
#include "files/feature_settings.h"
#include <stdexcept>

namespace files {
namespace {

    constexpr int maxSize = 32768; // pixels: more than any screen, and width * height fits an int
    constexpr Range openHalfTurn { 0.001f, 179.999f, "an angle between 0 and 180 degrees" };

    void readFeature(const TableReader& table, const TomlEntry& entry, Features& features)
    {
        const auto set = [&](const auto& content) {
            if constexpr (std::is_constructible_v<FeatureValue, decltype(content)>)
                setFeatureValue(features, entry.key, content);
            else
                table.failFound(entry.value, "true, false, a count or a name");
        };
        try {
            std::visit(set, entry.value.content);
        } catch (const std::invalid_argument& error) {
            table.fail(entry.line, error.what());
        }
    }

    void readFeatures(TableReader& top, Features& features)
    {
        if (const TomlValue* value = top.find("features")) {
            const TableReader table(top.path(), *value);
            for (const TomlEntry& entry : table.entries())
                readFeature(table, entry, features);
        }
    }

}

void readCamera(TableReader& top, CameraConfig& camera)
{
    if (const TomlValue* value = top.find("camera")) {
        TableReader table(top.path(), *value);
        table.read("look_at", camera.lookAt);
        table.read("rotation", camera.rotation);
        table.read("distance", camera.distanceFromLookAt, notNegative);
        table.read("field_of_view", camera.fieldOfView, openHalfTurn);
        table.finish();
    }
}

Config readConfig(TableReader& top)
{
    Config config;
    top.read("size", config.size, 1, maxSize);
    readCamera(top, config.camera);
    readFeatures(top, config.features);
    return config;
}

}
