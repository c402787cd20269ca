#include "files/scene_lights.h"

namespace files {
namespace {

    PointLight readPointLight(TableReader& table, const Frame& frame)
    {
        PointLight light;
        table.require("position", light.position);
        table.require("color", light.color, notNegative);
        light.position = frame.point(light.position);
        return light;
    }

    SegmentLight readSegmentLight(TableReader& table, const Frame& frame)
    {
        SegmentLight light;
        table.require("endpoint0", light.endpoint0);
        table.require("endpoint1", light.endpoint1);
        table.require("color0", light.color0, notNegative);
        table.require("color1", light.color1, notNegative);
        light.endpoint0 = frame.point(light.endpoint0);
        light.endpoint1 = frame.point(light.endpoint1);
        return light;
    }

    ParallelogramLight readParallelogramLight(TableReader& table, const Frame& frame)
    {
        ParallelogramLight light;
        table.require("v0", light.v0);
        table.require("edge01", light.edge01);
        table.require("edge02", light.edge02);
        table.require("color0", light.color0, notNegative);
        table.require("color1", light.color1, notNegative);
        table.require("color2", light.color2, notNegative);
        table.require("color3", light.color3, notNegative);
        light.v0 = frame.point(light.v0);
        light.edge01 = frame.edge(light.edge01);
        light.edge02 = frame.edge(light.edge02);
        return light;
    }

    Scene::SceneLight readLightOfType(TableReader& table, const Frame& frame)
    {
        const TomlValue* type = table.find("type");
        const auto* name = type ? std::get_if<std::string>(&type->content) : nullptr;
        if (name != nullptr && *name == "point")
            return readPointLight(table, frame);
        if (name != nullptr && *name == "segment")
            return readSegmentLight(table, frame);
        if (name != nullptr && *name == "parallelogram")
            return readParallelogramLight(table, frame);
        constexpr const char* expected = "the type \"point\", \"segment\" or \"parallelogram\"";
        if (type == nullptr)
            table.fail(table.line(), std::string("found a light without a type, expected ") + expected);
        table.failFound(*type, expected);
    }

}

Scene::SceneLight readLight(TableReader& table, const Frame& frame)
{
    bool inWorld = false;
    table.read("in_world", inWorld);
    const Scene::SceneLight light = readLightOfType(table, inWorld ? Frame {} : frame);
    table.finish();
    return light;
}

}
