#pragma once
#include <cstdint>

namespace accel {

// Rays by why they were traced. Those towards a light that ask for the closest hit are told apart where a debug::Watch
// is open, and are counted with those of the path where none is.
struct RayCounts {
    uint64_t camera = 0; // through a pixel
    uint64_t bounced = 0; // mirrored, or passed through a surface
    uint64_t shadow = 0; // towards a light
    uint64_t unlit = 0; // left out: towards a light that the surface could not show
    uint64_t clear = 0; // left out: towards a light with nothing on the way to any of its points

    // Of those that were traced.
    [[nodiscard]] uint64_t total() const { return camera + bounced + shadow; }
    [[nodiscard]] uint64_t leftOut() const { return unlit + clear; }

    RayCounts& operator+=(const RayCounts& other)
    {
        camera += other.camera;
        bounced += other.bounced;
        shadow += other.shadow;
        unlit += other.unlit;
        clear += other.clear;
        return *this;
    }
    [[nodiscard]] RayCounts operator-(const RayCounts& before) const
    {
        return { camera - before.camera, bounced - before.bounced, shadow - before.shadow, unlit - before.unlit,
            clear - before.clear };
    }
};

}
