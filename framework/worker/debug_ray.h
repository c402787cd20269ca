#pragma once
#include "debug/texels.h"
#include "worker/render_request.h"
#include "worker/shape_message.h"
#include <framework/trackball.h>

namespace worker {

// What the probe debug.ray is asked for: one ray, through the middle of a pixel.
struct DebugRayRequest {
    RenderRequest render;
    glm::ivec2 pixel { 0 }; // from the bottom left
};

// A texture that was looked up on the way.
struct TextureLookup {
    uint32_t texture = 0; // index into the scene's
    glm::ivec2 size { 0 }; // of the texture, in texels
    glm::vec2 texCoord { 0.0f };
    debug::Cause cause;
    std::vector<debug::Texel> texels; // that took part
};

// What the submission's code did with it, and what it drew.
struct DebugRay {
    glm::ivec2 size { 0 }; // of the picture, in pixels
    glm::ivec2 pixel { 0 };
    Trackball camera;
    glm::vec3 color { 0.0f };
    std::vector<debug::Shape> shapes;
    std::vector<debug::Hit> hits; // their materials' textures mean nothing here
    std::vector<TextureLookup> lookups;
    std::vector<glm::vec2> samples; // where the pixel's rays go through it, in [0, 1) x [0, 1) if they do
    std::size_t numDropped = 0; // shapes and lookups that were too many
};

inline Message& operator<<(Message& message, const DebugRayRequest& r)
{
    return message << r.render << r.pixel;
}

inline Reader& operator>>(Reader& reader, DebugRayRequest& r)
{
    return reader >> r.render >> r.pixel;
}

inline Message& operator<<(Message& message, const TextureLookup& l)
{
    return message << l.texture << l.size << l.texCoord << l.cause << l.texels;
}

inline Reader& operator>>(Reader& reader, TextureLookup& l)
{
    return reader >> l.texture >> l.size >> l.texCoord >> l.cause >> l.texels;
}

inline Message& operator<<(Message& message, const DebugRay& r)
{
    return message << r.size << r.pixel << r.camera << r.color << r.shapes << r.hits << r.lookups << r.samples
                   << r.numDropped;
}

inline Reader& operator>>(Reader& reader, DebugRay& r)
{
    return reader >> r.size >> r.pixel >> r.camera >> r.color >> r.shapes >> r.hits >> r.lookups >> r.samples
        >> r.numDropped;
}

}
