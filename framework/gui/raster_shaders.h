#pragma once
#include <fmt/format.h>
#include <string>

// What draws a scene as the tracer would, but for shadows, highlights and reflections. Positions are relative to the
// camera's: close to it they keep all their digits.
namespace gui {

inline constexpr const char* rasterVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 vertexNormal;
layout(location = 2) in vec2 vertexTexCoord;
uniform vec3 eye;
uniform mat4 toClip;
out vec3 fromEye;
out vec3 normal;
out vec2 texCoord;

void main()
{
    fromEye = position - eye;
    normal = vertexNormal;
    texCoord = vertexTexCoord;
    gl_Position = toClip * vec4(fromEye, 1.0);
}
)";

// The number is a constant of the program, so that the loop over them can be unrolled: where a processor does the work
// of the graphics card, an index that varies halves the frames a second.
[[nodiscard]] inline std::string rasterFragmentHead(std::size_t numLights)
{
    return fmt::format("#version 330 core\nconst int numLights = {};\n", numLights);
}

// To be preceded by rasterFragmentHead.
inline constexpr const char* rasterFragmentShader = R"(
in vec3 fromEye;
in vec3 normal;
in vec2 texCoord;
uniform bool isTextured, isShaded, isSmooth;
uniform sampler2D kdTexture;
uniform vec3 kd;
uniform float alpha;
uniform vec3 lights[numLights]; // relative to the camera
uniform vec3 lightColors[numLights];
out vec4 color;

// Unit, on the side that is seen.
vec3 facingNormal()
{
    vec3 n = normalize(isSmooth ? normal : cross(dFdx(fromEye), dFdy(fromEye)));
    return dot(n, fromEye) > 0.0 ? -n : n;
}

void main()
{
    vec3 n = facingNormal();
    vec3 light = vec3(0.0);
    for (int i = 0; i < numLights; ++i)
        light += lightColors[i] * (isShaded ? max(dot(n, normalize(lights[i] - fromEye)), 0.0) : 1.0);
    color = vec4(light * (isTextured ? texture(kdTexture, texCoord).rgb : kd), alpha);
}
)";

}
