#pragma once
// Course files take these for granted.
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <memory>
#include <tuple>
#include <vector>

#include <framework/mesh.h>
#include <framework/ray.h>

enum class DrawMode { Filled, Wireframe };

enum class ShadingModel { Lambertian = 0, Phong = 1, BlinnPhong = 2, LinearGradient = 3, LinearGradientComparison = 4 };

// Whether a gradient takes the place of the surface's colour.
[[nodiscard]] inline bool isByGradient(ShadingModel model)
{
    return model == ShadingModel::LinearGradient || model == ShadingModel::LinearGradientComparison;
}

// What a ray met at origin + t * direction.
struct HitInfo {
    glm::vec3 normal; // unit, on the side the ray came from
    glm::vec3 barycentricCoord; // (alpha, beta, gamma) for (v0, v1, v2); 0 on spheres
    glm::vec2 texCoord; // 0 on spheres
    Material material;
};

// The points p with dot(p, normal) == D.
struct Plane {
    float D = 0.0f;
    glm::vec3 normal { 0.0f, 1.0f, 0.0f };
};

struct AxisAlignedBox {
    glm::vec3 lower { 0.0f };
    glm::vec3 upper { 1.0f };
};

struct Sphere {
    glm::vec3 center { 0.0f };
    float radius = 1.0f;
    Material material;
};

struct PointLight {
    glm::vec3 position;
    glm::vec3 color;
};

struct SegmentLight {
    glm::vec3 endpoint0, endpoint1;
    glm::vec3 color0, color1; // at the endpoints, linear in between
};

struct ParallelogramLight {
    glm::vec3 v0; // a corner
    glm::vec3 edge01, edge02; // from v0 to its neighbours
    glm::vec3 color0, color1, color2, color3; // at v0, v0 + edge01, v0 + edge02 and opposite v0; bilinear in between
};

struct ExtraFeatures {
    bool enableBvhSahBinning = false;
    bool enableBloomEffect = false;
    bool enableDepthOfField = false;
    bool enableEnvironmentMap = false;
    bool enableGlossyReflection = false;
    bool enableMipmapTextureFiltering = false;
    bool enableMotionBlur = false;
    bool enableSkipping = true; // work that cannot change the picture is left out
    bool enableOwenSampling = false; // random numbers that are spread evenly, rather than independent ones

    uint32_t numGlossySamples = 1; // rays a glossy reflection
    uint32_t maxDepth = 6; // rays that follow one another from a pixel's on, mirrored or passed through; 6 at most
    bool enableProposedShadowFormula = false; // light * kd * (1 - t) + light * t behind transparent surfaces
};

struct Features {
    bool enableShading = false;
    bool enableReflections = false;
    bool enableShadows = false;
    bool enableNormalInterp = false;
    bool enableTextureMapping = false;
    bool enableAccelStructure = false;
    bool enableBilinearTextureFiltering = false;
    bool enableTransparency = false;
    bool enableJitteredSampling = false; // stratified rather than uniform samples in a pixel
    bool enableDebugDraw = false;

    ShadingModel shadingModel = ShadingModel::Lambertian;
    uint32_t numPixelSamples = 1; // rays a pixel
    uint32_t numShadowSamples = 4; // samples an area light

    ExtraFeatures extra = {};
};
