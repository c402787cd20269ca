#pragma once

namespace accel::wide {

// All segments that leave one point by slopes within a rectangle, each as far as it likes up to a plane: what may lie
// on the way to a light. Haines, Wallace 1991, "Shaft Culling for Efficient Ray-Traced Radiosity".
struct Shaft {
    float point[4]; // in space; nobody looks at the fourth
    unsigned axes[3]; // of space, that are x, y, z below: z is the longest coordinate of every segment
    float least[2], largest[2]; // of x / z and y / z: less than 1 in size
    float end; // the plane's z, seen from the point; not 0
};

}
