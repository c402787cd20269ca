#pragma once
#include "accel/wide/node.h"
#include <framework/ray.h>

namespace accel::wide {

// How a ray is turned and sheared so that it becomes the z axis. Woop, Benthin, Wald 2013, "Watertight Ray/Triangle
// Intersection".
template <typename Simd> struct Shear {
    Shear() = default;

    explicit Shear(const Ray& ray)
    {
        const float d[3] = { ray.direction.x, ray.direction.y, ray.direction.z };
        const float from[3] = { ray.origin.x, ray.origin.y, ray.origin.z };
        const float sizeX = __builtin_fabsf(d[0]), sizeY = __builtin_fabsf(d[1]), sizeZ = __builtin_fabsf(d[2]);
        const unsigned zLargest = (sizeZ > sizeX) & (sizeZ > sizeY); // no jumps
        const unsigned yLargest = (sizeY > sizeX) & ~zLargest & 1;
        axes[2] = 2 * zLargest | yLargest;
        axes[0] = (9 >> 2 * axes[2]) & 3; // the next two: 1 2 0, 2 0 1
        axes[1] = (18 >> 2 * axes[2]) & 3;
        for (int i = 0; i < 3; ++i)
            origin[i] = from[axes[i]];
        scale = 1.0f / d[axes[2]];
        x = d[axes[0]] * scale;
        y = d[axes[1]] * scale;
    }

    unsigned axes[3]; // that become x, y, z
    float origin[3]; // along these
    float x, y, scale;
};

// A triangle seen along a ray; many of both, one in each place.
template <typename Simd> struct Sheared {
    using Floats = typename Simd::Floats;

    // corners: less the ray's origin, along its axes; axis, corner. An edge function is negative, positive or zero for
    // all triangles that share the edge, but for its sign, if the products are rounded before they are subtracted: no
    // fused multiply-add here.
    Sheared(const Floats (&corners)[3][3], Floats shearX, Floats shearY)
    {
        for (int i = 0; i < 3; ++i) {
            z[i] = corners[2][i];
            x[i] = corners[0][i] - shearX * z[i];
            y[i] = corners[1][i] - shearY * z[i];
        }
        weights[0] = x[2] * y[1] - y[2] * x[1];
        weights[1] = x[0] * y[2] - y[0] * x[2];
        weights[2] = x[1] * y[0] - y[1] * x[0];
        least = Simd::min(Simd::min(weights[0], weights[1]), weights[2]);
        most = Simd::max(Simd::max(weights[0], weights[1]), weights[2]);
    }

    [[nodiscard]] unsigned candidates() const
    {
        const Floats zero = Simd::broadcast(0.0f);
        return Simd::lessEqual(zero, least) | Simd::lessEqual(most, zero);
    }

    // Those of the candidates whose weights have signs. A weight of zero may be one of any sign that was rounded.
    [[nodiscard]] unsigned certain() const
    {
        const Floats zero = Simd::broadcast(0.0f);
        return Simd::less(zero, least) | Simd::less(most, zero);
    }

    // Those of the second and the third corner, normalised: as many numbers each as a register has.
    void storeWeights(float* second, float* third) const
    {
        const Floats sum = weights[0] + weights[1] + weights[2];
        Simd::store(second, weights[1] / sum);
        Simd::store(third, weights[2] / sum);
    }

    Floats x[3], y[3], z[3]; // of the corners
    Floats weights[3]; // of the corners, unnormalised
    Floats least, most; // of the weights
};

// The plane of a triangle, for the distance of a hit: a weighted sum of the corners loses digits on huge triangles. In
// the order of intersectRayWithTriangle, for the same bits.
template <typename Simd> struct TrianglePlane {
    using Floats = typename Simd::Floats;

    TrianglePlane(const Floats (&first)[3], const Floats (&second)[3], const Floats (&third)[3], const float* origin)
    {
        Floats corner[3], edge1[3], edge2[3];
        for (int axis = 0; axis < 3; ++axis) {
            corner[axis] = first[axis] - Simd::broadcast(origin[axis]);
            edge1[axis] = second[axis] - first[axis];
            edge2[axis] = third[axis] - first[axis];
        }
        normal[0] = edge1[1] * edge2[2] - edge1[2] * edge2[1];
        normal[1] = edge1[2] * edge2[0] - edge1[0] * edge2[2];
        normal[2] = edge1[0] * edge2[1] - edge1[1] * edge2[0];
        height = normal[0] * corner[0] + normal[1] * corner[1] + normal[2] * corner[2];
    }

    // In units of |direction|. Within what the corners allow but for rounding: seen edge-on, the plane's equation loses
    // all digits. Not a number gives way to that, as a first operand.
    [[nodiscard]] Floats distances(
        Floats directionX, Floats directionY, Floats directionZ, const Sheared<Simd>& s, Floats scale) const
    {
        const Floats slope = normal[0] * directionX + normal[1] * directionY + normal[2] * directionZ;
        const Floats first = s.z[0] * scale, second = s.z[1] * scale, third = s.z[2] * scale;
        const Floats nearest = Simd::min(Simd::min(first, second), third) * Simd::broadcast(1.0f - 0x1p-21f);
        const Floats farthest = Simd::max(Simd::max(first, second), third) * Simd::broadcast(1.0f + 0x1p-21f);
        return Simd::min(Simd::max(height / slope, nearest), farthest);
    }

    Floats normal[3], height;
};

}
