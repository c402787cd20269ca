#pragma once

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

inline constexpr const char* rasterFragmentShader = R"(#version 330 core
in vec3 fromEye;
in vec3 normal;
in vec2 texCoord;
uniform bool isTextured, isShaded, isSmooth;
uniform sampler2D kdTexture;
uniform vec3 kd;
uniform float alpha;
uniform vec3 light; // relative to the camera
uniform vec3 lightColor;
out vec4 color;

// The cosine between the light and the normal on the side that is seen.
float lambert()
{
    vec3 n = normalize(isSmooth ? normal : cross(dFdx(fromEye), dFdy(fromEye)));
    vec3 facing = dot(n, fromEye) > 0.0 ? -n : n;
    return max(dot(facing, normalize(light - fromEye)), 0.0);
}

void main()
{
    vec3 surface = isTextured ? texture(kdTexture, texCoord).rgb : kd;
    color = vec4(lightColor * surface * (isShaded ? lambert() : 1.0), alpha);
}
)";

}
