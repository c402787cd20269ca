#include "app/debug_ray_json.h"
#include <framework/variant_helper.h>
#include <nlohmann/json.hpp>

namespace app {
namespace {

    using json = nlohmann::ordered_json;

    template <int N, typename T> json toArray(const glm::vec<N, T>& v)
    {
        json array = json::array();
        for (int i = 0; i < N; ++i)
            array.push_back(v[i]);
        return array;
    }

    json toObject(const debug::Cause& cause)
    {
        return { { "bounce", cause.bounce }, { "way", cause.way == debug::Way::Shadow ? "shadow" : "path" } };
    }

    json toObject(const debug::Drawn& drawn)
    {
        using namespace debug;
        return std::visit(
            make_visitor(
                [](const DrawnRay& r) -> json {
                    return { { "type", "ray" }, { "origin", toArray(r.ray.origin) },
                        { "direction", toArray(r.ray.direction) }, { "t", r.ray.t }, { "color", toArray(r.color) } };
                },
                [](const DrawnBox& b) -> json {
                    return { { "type", "box" }, { "lower", toArray(b.box.lower) }, { "upper", toArray(b.box.upper) },
                        { "filled", b.mode == DrawMode::Filled }, { "color", toArray(b.color) },
                        { "transparency", b.transparency } };
                },
                [](const DrawnTriangle& t) -> json {
                    return { { "type", "triangle" },
                        { "vertices", { toArray(t.v0.position), toArray(t.v1.position), toArray(t.v2.position) } } };
                },
                [](const DrawnSphere& s) -> json {
                    return { { "type", "sphere" }, { "center", toArray(s.center) }, { "radius", s.radius },
                        { "color", toArray(s.color) } };
                }),
            drawn);
    }

    json toObject(const debug::Hit& hit)
    {
        const auto& [normal, barycentric, texCoord, material] = hit.hitInfo;
        json object = toObject(hit.cause);
        object["point"] = toArray(hit.ray.origin + hit.ray.t * hit.ray.direction);
        object["normal"] = toArray(normal);
        object["barycentric"] = toArray(barycentric);
        object["texCoord"] = toArray(texCoord);
        object["kd"] = toArray(material.kd);
        object["ks"] = toArray(material.ks);
        object["transparency"] = material.transparency;
        return object;
    }

    json toObject(const worker::TextureLookup& lookup)
    {
        json object = toObject(lookup.cause);
        object["texture"] = lookup.texture;
        object["size"] = toArray(lookup.size);
        object["texCoord"] = toArray(lookup.texCoord);
        object["texels"] = json::array();
        for (const debug::Texel& texel : lookup.texels)
            object["texels"].push_back({ { "index", toArray(texel.index) }, { "weight", texel.weight } });
        return object;
    }

}

std::string toJson(const worker::DebugRay& ray)
{
    json root { { "size", toArray(ray.size) }, { "pixel", toArray(ray.pixel) }, { "color", toArray(ray.color) },
        { "dropped", ray.numDropped }, { "shapes", json::array() }, { "hits", json::array() },
        { "lookups", json::array() }, { "samples", json::array() } };
    for (const debug::Shape& shape : ray.shapes) {
        json object = toObject(shape.cause);
        object.update(toObject(shape.drawn));
        root["shapes"].push_back(std::move(object));
    }
    for (const debug::Hit& hit : ray.hits)
        root["hits"].push_back(toObject(hit));
    for (const worker::TextureLookup& lookup : ray.lookups)
        root["lookups"].push_back(toObject(lookup));
    for (const glm::vec2& sample : ray.samples)
        root["samples"].push_back(toArray(sample));
    return root.dump(2) + "\n";
}

}
