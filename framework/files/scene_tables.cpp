#include "files/scene_tables.h"
#include "files/feature_settings.h"
#include <array>
#include <charconv>

namespace files {
namespace {

    // As one would write the number, 0.1 rather than 0.10000000149011612. The few floats whose own shortest text is
    // another float once it has been rounded to a double keep all of their digits.
    double shortDouble(float number)
    {
        std::array<char, 32> digits;
        const auto end = std::to_chars(digits.begin(), digits.end(), number).ptr;
        double written = 0.0;
        std::from_chars(digits.begin(), end, written);
        return static_cast<float>(written) == number ? written : number;
    }

    template <typename T> TomlValue valueOf(const T& content)
    {
        return { .content = content };
    }
    TomlValue valueOf(const char* name)
    {
        return valueOf(std::string(name));
    }
    TomlValue valueOf(int number)
    {
        return valueOf(int64_t { number });
    }
    TomlValue valueOf(float number)
    {
        return valueOf(shortDouble(number));
    }
    TomlValue valueOf(const glm::ivec2& v)
    {
        return valueOf(TomlValue::Array { valueOf(v.x), valueOf(v.y) });
    }
    TomlValue valueOf(const glm::vec3& v)
    {
        return valueOf(TomlValue::Array { valueOf(v.x), valueOf(v.y), valueOf(v.z) });
    }

    template <typename T> TomlEntry entryOf(const char* key, const T& value)
    {
        return { key, valueOf(value) };
    }

    // What is not as a scene file has it anyway.
    TomlValue::Table featuresTable(const Features& features)
    {
        TomlValue::Table table;
        for (const std::string& name : featureNames()) {
            const FeatureValue value = featureValue(features, name);
            if (value != featureValue(Features {}, name))
                table.push_back({ name, std::visit([](const auto& v) { return valueOf(v); }, value) });
        }
        return table;
    }

    TomlValue::Table tableOf(const PointLight& light)
    {
        return { entryOf("type", "point"), entryOf("position", light.position), entryOf("color", light.color) };
    }

    TomlValue::Table tableOf(const SegmentLight& light)
    {
        return { entryOf("type", "segment"), entryOf("endpoint0", light.endpoint0),
            entryOf("endpoint1", light.endpoint1), entryOf("color0", light.color0), entryOf("color1", light.color1) };
    }

    TomlValue::Table tableOf(const ParallelogramLight& light)
    {
        return { entryOf("type", "parallelogram"), entryOf("v0", light.v0), entryOf("edge01", light.edge01),
            entryOf("edge02", light.edge02), entryOf("color0", light.color0), entryOf("color1", light.color1),
            entryOf("color2", light.color2), entryOf("color3", light.color3) };
    }

}

TomlEntry cameraEntry(const CameraConfig& camera)
{
    const TomlValue::Table table { entryOf("look_at", camera.lookAt), entryOf("rotation", camera.rotation),
        entryOf("distance", camera.distanceFromLookAt), entryOf("field_of_view", camera.fieldOfView) };
    return entryOf("camera", table);
}

TomlValue::Table configTables(const Config& config)
{
    return { entryOf("size", config.size), cameraEntry(config.camera),
        entryOf("features", featuresTable(config.features)) };
}

TomlEntry lightTables(const std::vector<Scene::SceneLight>& lights, bool hasFrame)
{
    TomlValue::Array tables;
    for (const Scene::SceneLight& light : lights) {
        TomlValue::Table table = std::visit([](const auto& kind) { return tableOf(kind); }, light);
        if (hasFrame) // back through the frame they would be rounded
            table.push_back(entryOf("in_world", true));
        tables.push_back(valueOf(table));
    }
    return entryOf("light", tables);
}

}
