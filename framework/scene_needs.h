#pragma once

// What a picture needs: of a part that is false nothing can be seen in it, so whoever computes it may leave that out.
// All of it, unless somebody has looked at the scene and its features.
struct SceneNeeds {
    bool triangles = true;
    bool spheres = true;
    bool textures = true; // or colours of surfaces by a function of the submission
    bool shadingNormals = true; // interpolated from those of the corners
    bool mirrors = true;
    bool transparency = true;
    bool pointLights = true;
    bool areaLights = true; // segments and parallelograms
    bool environment = true;
    bool pixelRays = true; // a pixel's list of rays, and the mean of what they see, rather than one ray
    bool shadows = true;
    bool shadowsInOrder = true; // which surface is first on the way to a light, rather than whether there is one
    bool lightFromBehind = true; // light that reaches a surface from below it, or is black, or meets a black surface
};
